// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_registry.h"

#include <string>

#include "boxplus/io/camera_fields.h"
#include "boxplus/types/ba.h"

namespace boxplus {
namespace {

/// The tags of one camera model: the camera as a parameter and as a vertex, and the observations of both. On
/// a rig, the pose of the sensor is a parameter or a vertex like the camera.
template <class Camera>
void register_camera(Registry& registry) {
  const std::string name(Camera::kName);
  std::string fields;
  for (int i = 0; i < Camera::kSize; ++i) fields += i < Camera::Model::kFocalLengths ? " 500" : " 0.125";
  registry.parameter<Camera>("PARAMS_CAMERA_" + name, "20" + fields);
  registry.vertex<Camera>("VERTEX_CAMERA_" + name, "20" + fields);
  registry.edge<Reprojection<Camera>, SE3, Vector3, Parameter<Camera>>("EDGE_REPROJECTION_" + name,
                                                                       "0 2 20 1.5 2.5 1 0 1");
  registry.edge<Reprojection<Camera>, SE3, Vector3, Camera>("EDGE_REPROJECTION_CALIB_" + name,
                                                            "0 2 20 1.5 2.5 1 0 1");
  registry.edge<Reprojection<Camera>, SE3, Vector3, Parameter<SE3>, Parameter<Camera>>(
      "EDGE_REPROJECTION_RIG_" + name, "0 2 5 20 1.5 2.5 1 0 1");
  registry.edge<Reprojection<Camera>, SE3, Vector3, SE3, Camera>("EDGE_REPROJECTION_RIG_CALIB_" + name,
                                                                 "0 2 5 20 1.5 2.5 1 0 1");
}

}  // namespace

const Registry& json_registry() {
  static const Registry registry = [] {
    Registry all = default_registry();
    detail::CameraList::for_each([&]<class Camera>() { register_camera<Camera>(all); });
    all.vertex<Product<SE3, BalCamera>>("VERTEX_SE3_BAL", "21 1 2 3 0 0 0.6 0.8 500 0.1 0.01");
    all.edge<Reprojection<BalCamera>, Product<SE3, BalCamera>, Vector3>("EDGE_REPROJECTION_SE3_BAL",
                                                                        "21 2 1.5 2.5 1 0 1");
    return all;
  }();
  return registry;
}

}  // namespace boxplus
