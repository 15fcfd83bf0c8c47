// SPDX-License-Identifier: BSD-3-Clause
#include "io/json/json_registry.h"

#include <string>

#include "boxplus/io/camera_fields.h"
#include "boxplus/io/inertial_fields.h"
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

/// The fields of an example: Ω = I with this number of rows.
std::string identity_fields(int rows) {
  std::string fields;
  for (int i = 0; i < rows; ++i) {
    for (int j = i; j < rows; ++j) fields += i == j ? " 1" : " 0";
  }
  return fields;
}

/// The tags of inertial sensors, and of what is used with them.
void register_inertial(Registry& registry) {
  registry.vertex<ImuBias>("VERTEX_IMU_BIAS", "31 0.1 0.2 0.3 0.4 0.5 0.6");
  registry.vertex<S2>("VERTEX_DIRECTION", "32 0 0.6 -0.8");
  registry.parameter<S2>("PARAMS_DIRECTION", "33 0 0 -1");
  registry.parameter<Vector3>("PARAMS_POINT", "34 0.5 0 1");
  std::string motion = " 1 2 3 0 0 0.6 0.8 0.5 0.25 -1 0.5 0.01 0.02 0.03 0.1 0.2 0.3";
  for (int i = 0; i < 9 * 6; ++i) motion += i % 7 == 0 ? " -0.5" : " 0.125";
  motion += " 0 0 -9.8" + identity_fields(15);
  registry.edge<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias>("EDGE_INERTIAL",
                                                                               "0 2 31 1 3 35" + motion);
  registry.edge<InertialBetween, SE3, Vector3, ImuBias, SE3, Vector3, ImuBias, S2>(
      "EDGE_INERTIAL_GRAVITY", "0 2 31 1 3 35 32" + motion);
  registry.edge<DirectionObservation, SE3, S2>("EDGE_DIRECTION_CALIB", "0 32 0.6 0 0.8 1 0 1");
  registry.edge<DirectionObservation, SE3, Parameter<S2>>("EDGE_DIRECTION", "0 33 0.6 0 0.8 1 0 1");
  registry.edge<FieldObservation, SE3, Vector3, Vector3>("EDGE_FIELD", "0 2 3 0.1 0.2 0.3 1 0 0 1 0 1");
  registry.edge<OffsetPositionPrior<Vector3>, SE3, Vector3>("EDGE_POSITION_CALIB", "0 2 1 2 3 1 0 0 1 0 1");
  registry.edge<OffsetPositionPrior<Vector3>, SE3, Parameter<Vector3>>("EDGE_POSITION",
                                                                       "0 34 1 2 3 1 0 0 1 0 1");
}

}  // namespace

const Registry& json_registry() {
  static const Registry registry = [] {
    Registry all = default_registry();
    detail::CameraList::for_each([&]<class Camera>() { register_camera<Camera>(all); });
    register_inertial(all);
    all.vertex<Product<SE3, BalCamera>>("VERTEX_SE3_BAL", "21 1 2 3 0 0 0.6 0.8 500 0.1 0.01");
    all.edge<Reprojection<BalCamera>, Product<SE3, BalCamera>, Vector3>("EDGE_REPROJECTION_SE3_BAL",
                                                                        "21 2 1.5 2.5 1 0 1");
    return all;
  }();
  return registry;
}

}  // namespace boxplus
