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

template <class Native>
Vector3 depth_image_error(const Vector3& z, const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                          const ParameterCamera& camera) {
  return Native(z).error(pose(robot), point(point_vertex), mounted_camera(camera));
}

/// The Jacobians with respect to the robot's pose and the point.
template <class Native, class Xi, class Xj>
void linearize_depth_image(const VertexSE3& robot, const VertexPointXYZ& point_vertex,
                           const ParameterCamera& camera, Xi& xi, Xj& xj) {
  linearize(Native(boxplus::Vector3(0, 0, 0)), Argument<boxplus::SE3>{pose(robot), xi.data()},
            Argument<boxplus::Vector3>{point(point_vertex), xj.data()},
            Argument<MountedCamera>{mounted_camera(camera), nullptr});
}

}  // namespace adapters
}  // namespace g2o
