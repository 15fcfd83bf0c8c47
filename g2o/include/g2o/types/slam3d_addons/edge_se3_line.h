// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_LINE3D_H_
#define G2O_EDGE_SE3_LINE3D_H_

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/vertex_line3d.h"

namespace g2o {

/// A line z in the frame of a sensor. x is the pose of the robot, and P is the pose of the sensor on the
/// robot. Error: ((x P)⁻¹ line).ominus(z). Tag: EDGE_SE3_LINE3D.
/// The measurement data are the six Plücker coordinates of the line.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Line3D
    : public ReadyMadeEdge<EdgeSE3Line3D, 4, Line3D, VertexSE3, VertexLine3D> {
 public:
  EdgeSE3Line3D();

  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

  Vector3 color = Vector3(0, 0.5, 1);  ///< red, green, blue in [0, 1]; not saved in files

 protected:
  ParameterSE3Offset* offsetParam = nullptr;
};

/// The action "draw" of EdgeSE3Line3D.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Line3DDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3Line3DDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_LINE3D_H_
