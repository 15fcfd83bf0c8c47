// SPDX-License-Identifier: BSD-3-Clause
// Edges for the image of a point in a camera whose intrinsics are a parameter of the graph.
#include "boxplus/types/ba/inverse_depth.h"
#include "g2o/types/sba/edge_project_psi2uv.h"
#include "g2o/types/sba/edge_project_xyz2uv.h"
#include "g2o/types/sba/edge_project_xyz2uvu.h"
#include "types/sba/image_model.h"

namespace g2o {
namespace {

using Image = boxplus::InverseDepthImage;

/// The pose of a camera, given the motion from the world to the camera.
boxplus::SE3RotationVector pose_of(const VertexSE3Expmap& camera) {
  const boxplus::SE3 pose = adapters::pose(camera.estimate().inverse());
  return boxplus::SE3RotationVector::from_unit(pose.translation(), pose.quaternion());
}

}  // namespace

namespace internal {

template <>
struct EdgeModel<EdgeProjectXYZ2UV> : ImageModel<EdgeProjectXYZ2UV> {
  static std::tuple<> parameters(const EdgeProjectXYZ2UV&) { return {}; }
  static adapters::Pinhole camera(const EdgeProjectXYZ2UV& e) { return adapters::camera(*e._cam).pinhole(); }
  static Vector2 image(const EdgeProjectXYZ2UV& e, const Vector3& p) { return e._cam->cam_map(p); }
};

template <>
struct EdgeModel<EdgeProjectXYZ2UVU> : ImageModel<EdgeProjectXYZ2UVU> {
  static std::tuple<> parameters(const EdgeProjectXYZ2UVU&) { return {}; }
  static adapters::Pinhole camera(const EdgeProjectXYZ2UVU& e) { return adapters::camera(*e._cam).pinhole(); }
  static Vector3 image(const EdgeProjectXYZ2UVU& e, const Vector3& p) { return e._cam->stereocam_uvu_map(p); }
};

// The error is the negative of the engine's, and a step T ← exp(ω, υ) T changes the pose X = T⁻¹ of the
// engine to X exp(−ω, −υ). The signs cancel.
template <>
struct EdgeModel<EdgeProjectPSI2UV> {
  using Edge = EdgeProjectPSI2UV;
  static std::tuple<> parameters(const Edge&) { return {}; }
  static Vector2 error(const Edge& e) {
    return -Image(e.measurement())
                .error(native_value(*e.vertexXn<0>()), pose_of(*e.vertexXn<1>()), pose_of(*e.vertexXn<2>()),
                       adapters::camera(*e._cam));
  }
  static void linearize(Edge& e) {
    Eigen::Matrix<double, 2, 3> by_point;
    Eigen::Matrix<double, 2, 6> by_pose, by_anchor;
    adapters::linearize(Image(e.measurement()),
                        adapters::Argument{native_value(*e.vertexXn<0>()), by_point.data()},
                        adapters::Argument{pose_of(*e.vertexXn<1>()), by_pose.data()},
                        adapters::Argument{pose_of(*e.vertexXn<2>()), by_anchor.data()},
                        adapters::Argument{adapters::camera(*e._cam), nullptr});
    e.jacobianOplusXn<0>() = -by_point;
    e.jacobianOplusXn<1>() << by_pose.rightCols<3>(), by_pose.leftCols<3>();
    e.jacobianOplusXn<2>() << by_anchor.rightCols<3>(), by_anchor.leftCols<3>();
  }
};

template struct EdgeFunctions<EdgeProjectXYZ2UV>;
template struct EdgeFunctions<EdgeProjectXYZ2UVU>;
template struct EdgeFunctions<EdgeProjectPSI2UV>;

}  // namespace internal

EdgeProjectXYZ2UV::EdgeProjectXYZ2UV() {
  resizeParameters(1);
  installParameter(_cam, 0);
}

EdgeProjectXYZ2UVU::EdgeProjectXYZ2UVU() {
  resizeParameters(1);
  installParameter(_cam, 0);
}

EdgeProjectPSI2UV::EdgeProjectPSI2UV() {
  resizeParameters(1);
  installParameter(_cam, 0);
}

}  // namespace g2o
