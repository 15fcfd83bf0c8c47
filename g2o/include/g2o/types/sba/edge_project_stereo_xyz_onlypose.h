// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTSTEREOXYZONLYPOSE_H
#define G2O_SBA_EDGEPROJECTSTEREOXYZONLYPOSE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"

namespace g2o {

/// The measured image coordinates z (pixels) of the known point Xw in a stereo camera T. Error: z − (u, v,
/// u_right), with the image coordinates of T Xw as in EdgeStereoSE3ProjectXYZ. In files, the point and the
/// camera parameters follow Ω. Tag: EDGE_STEREO_SE3_PROJECT_XYZONLYPOSE:EXPMAP.
class G2O_TYPES_SBA_API EdgeStereoSE3ProjectXYZOnlyPose
    : public ReadyMadeEdge<EdgeStereoSE3ProjectXYZOnlyPose, 3, Vector3, VertexSE3Expmap> {
 public:
  EdgeStereoSE3ProjectXYZOnlyPose();

  /// Returns whether the point is in front of the cameras.
  virtual bool isDepthPositive();
  /// Returns (u, v, u_right) of a point in the frame of the left camera.
  Vector3 cam_project(const Vector3& trans_xyz) const;

  Vector3 Xw = Vector3(0, 0, 1);
  double fx = 1, fy = 1, cx = 0, cy = 0, bf = 1;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTSTEREOXYZONLYPOSE_H
