// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTXYZONLYPOSE_H
#define G2O_SBA_EDGEPROJECTXYZONLYPOSE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"

namespace g2o {

/// The measured image position z (pixels) of the known point Xw in a camera T. Error: z − (u, v), with the
/// image position (u, v) of T Xw. In files, the point and the camera parameters follow Ω. Tag:
/// EDGE_SE3_PROJECT_XYZONLYPOSE:EXPMAP.
class G2O_TYPES_SBA_API EdgeSE3ProjectXYZOnlyPose
    : public ReadyMadeEdge<EdgeSE3ProjectXYZOnlyPose, 2, Vector2, VertexSE3Expmap> {
 public:
  EdgeSE3ProjectXYZOnlyPose();

  /// Returns whether the point is in front of the camera.
  virtual bool isDepthPositive();
  /// Returns the image position of a point in the frame of the camera.
  Vector2 cam_project(const Vector3& trans_xyz) const;

  Vector3 Xw = Vector3(0, 0, 1);
  double fx = 1, fy = 1, cx = 0, cy = 0;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTXYZONLYPOSE_H
