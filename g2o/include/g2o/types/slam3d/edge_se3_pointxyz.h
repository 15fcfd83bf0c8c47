// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_POINT_XYZ_H_
#define G2O_EDGE_SE3_POINT_XYZ_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a sensor. x is the pose of the robot, and P is the
/// pose of the sensor on the robot. Error: (x P)⁻¹ l − z. Tag: EDGE_SE3_TRACKXYZ.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZ
    : public ReadyMadeEdge<EdgeSE3PointXYZ, 3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EdgeSE3PointXYZ();

  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

 protected:
  ParameterSE3Offset* offsetParam = nullptr;
};

/// The action "draw" of EdgeSE3PointXYZ.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3PointXYZDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_POINT_XYZ_H_
