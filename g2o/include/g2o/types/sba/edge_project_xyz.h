// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTXYZ_H
#define G2O_SBA_EDGEPROJECTXYZ_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured image position z (pixels) of a point p in a camera T. Error: z − (u, v), with the image
/// position (u, v) of T p. In files, the camera parameters follow Ω. If the camera parameters are missing,
/// image coordinates are normalized. Tag: EDGE_SE3_PROJECT_XYZ:EXPMAP.
class G2O_TYPES_SBA_API EdgeSE3ProjectXYZ
    : public ReadyMadeEdge<EdgeSE3ProjectXYZ, 2, Vector2, VertexPointXYZ, VertexSE3Expmap> {
 public:
  EdgeSE3ProjectXYZ();

  /// Returns whether the point is in front of the camera.
  virtual bool isDepthPositive();
  /// Returns the image position of a point in the frame of the camera.
  Vector2 cam_project(const Vector3& trans_xyz) const;

  double fx = 1, fy = 1, cx = 0, cy = 0;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTXYZ_H
