// SPDX-License-Identifier: BSD-3-Clause
// The common part of EDGE_PROJECT_DEPTH and EDGE_PROJECT_DISPARITY. Native is boxplus::DepthImage or
// boxplus::DisparityImage.
#pragma once

#include "boxplus/types/ba/depth_image.h"
#include "g2o/types/slam3d/parameter_camera.h"
#include "types/slam3d/adapters_slam3d.h"

namespace g2o {
namespace adapters {

using MountedCamera = boxplus::Product<boxplus::SE3, boxplus::PinholeCamera>;

inline MountedCamera mounted_camera(const ParameterCamera& camera) {
  const Matrix3& K = camera.Kcam();
  return MountedCamera(pose(camera), boxplus::PinholeCamera(K(0, 0), K(1, 1), K(0, 2), K(1, 2)));
}

/// A skew of K, which only a class derived from ParameterCamera can set, adds skew_ratio(K) · (v − c_y) to
/// the column u of a pixel (u, v).
inline double skew_ratio(const Matrix3& K) {
  return K(0, 1) == 0 ? 0 : K(0, 1) / K(1, 1);
}

template <class Native>
Vector3 depth_image_error(const Vector3& z, const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                          const ParameterCamera& camera) {
  Vector3 error = Native(z).error(pose(robot), point(point_vertex), mounted_camera(camera));
  const Matrix3& K = camera.Kcam();
  if (const double ratio = skew_ratio(K); ratio != 0) error[0] += ratio * (error[1] + z[1] - K(1, 2));
  return error;
}

/// The Jacobians with respect to the robot's pose and the point.
template <class Native, class Xi, class Xj>
void linearize_depth_image(const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                           const ParameterCamera& camera, Xi& xi, Xj& xj) {
  linearize(Native(boxplus::Vector3(0, 0, 0)), Argument<boxplus::SE3>{pose(robot), xi.data()},
            Argument<boxplus::Vector3>{point(point_vertex), xj.data()},
            Argument<MountedCamera>{mounted_camera(camera), nullptr});
  if (const double ratio = skew_ratio(camera.Kcam()); ratio != 0) {
    xi.row(0) += ratio * xi.row(1);
    xj.row(0) += ratio * xj.row(1);
  }
}

}  // namespace adapters
}  // namespace g2o
