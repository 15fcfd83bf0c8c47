// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGEPROJECTSTEREOXYZ_H
#define G2O_SBA_EDGEPROJECTSTEREOXYZ_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The images z of a point in a stereo camera (pixels): u, v, and u in the right camera. Error: z − (u, v,
/// u_right) of T p, with u_right = u − bf/depth. Files have the camera after Ω. If it is missing, the camera
/// has normalized coordinates. Tag: EDGE_STEREO_SE3_PROJECT_XYZ:EXPMAP.
class G2O_TYPES_SBA_API EdgeStereoSE3ProjectXYZ
    : public BaseBinaryEdge<3, Vector3, VertexPointXYZ, VertexSE3Expmap> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeStereoSE3ProjectXYZ();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<3, Vector3, VertexPointXYZ, VertexSE3Expmap>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// Whether the point is in front of the cameras.
  virtual bool isDepthPositive();
  /// The images of a point in the frame of the left camera; `bf` is the baseline times fx.
  Vector3 cam_project(const Vector3& trans_xyz, const double& bf) const;

  double fx = 1, fy = 1, cx = 0, cy = 0, bf = 1;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGEPROJECTSTEREOXYZ_H
