// SPDX-License-Identifier: BSD-3-Clause
// The common part of EDGE_PROJECT_DEPTH and EDGE_PROJECT_DISPARITY: the image of a point in a camera on a
// robot, and a function of the depth of the point.
#pragma once

#include "types/images.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace adapters {

/// An observation with the measurement zero. Its error is the position of the point in the frame of the
/// camera.
inline const boxplus::OffsetPointObservation3 kInCamera{boxplus::Vector3(0, 0, 0)};

/// Returns (u, v, Third::of(depth)) of a point p in the frame of the camera.
template <class Third>
Vector3 depth_image(const Matrix3& K, const Vector3& p) {
  Vector3 z;
  z << formulas::image(K, p), Third::of(p[2]);
  return z;
}

/// The Jacobian of depth_image() with respect to the point in the frame of the camera.
template <class Third>
Matrix3 depth_image_jacobian(const Matrix3& K, const Vector3& p) {
  Matrix3 D;
  D << formulas::image_jacobian(K, p), Third::derivative(p[2]) * Vector3::UnitZ().transpose();
  return D;
}

inline Vector3 point_in_camera(const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                               const ParameterCamera& camera) {
  return kInCamera.error(pose(robot), point(point_vertex), pose(camera));
}

/// The Jacobians of depth_image() with respect to the robot's pose and the point.
template <class Third, class Xi, class Xj>
void linearize_depth_image(const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                           const ParameterCamera& camera, Xi& xi, Xj& xj) {
  const boxplus::SE3 from = pose(robot), offset = pose(camera);
  const boxplus::Vector3 to = point(point_vertex);
  linearize(kInCamera, Argument<boxplus::SE3>{from, xi.data()}, Argument<boxplus::Vector3>{to, xj.data()},
            Argument<boxplus::SE3>{offset, nullptr});
  const Matrix3 D = depth_image_jacobian<Third>(camera.Kcam(), kInCamera.error(from, to, offset));
  xi = (D * xi).eval();
  xj = (D * xj).eval();
}

}  // namespace adapters
}  // namespace g2o
