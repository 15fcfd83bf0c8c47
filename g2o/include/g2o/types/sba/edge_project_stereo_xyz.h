// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTSTEREOXYZ_H
#define G2O_SBA_EDGEPROJECTSTEREOXYZ_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image coordinates z (pixels) of a point p in a stereo camera T. Error: z − (u, v, u_right),
/// with the image position (u, v) of T p and u_right = u − bf/depth. In files, the camera parameters follow
/// Ω. If the camera parameters are missing, image coordinates are normalized. Tag:
/// EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP.
class G2O_TYPES_SBA_API EdgeStereoSE3ProjectXYZ
    : public ReadyMadeEdge<EdgeStereoSE3ProjectXYZ, 3, Vector3, VertexPointXYZ, VertexSE3Expmap> {
 public:
  EdgeStereoSE3ProjectXYZ();

  /// Returns whether the point is in front of the cameras.
  virtual bool isDepthPositive();
  /// Returns (u, v, u_right) of a point in the frame of the left camera. `bf` is the baseline times fx.
  Vector3 cam_project(const Vector3& trans_xyz, const double& bf) const;

  double fx = 1, fy = 1, cx = 0, cy = 0, bf = 1;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTSTEREOXYZ_H
