// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_SEGMENT2D_POINTLINE_H
#define G2O_EDGE_SE2_SEGMENT2D_POINTLINE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "g2o/types/slam2d_addons/vertex_segment2d.h"

namespace g2o {

/// One measured end point (x, y) of a segment in the frame of a pose, and the measured angle θ of its normal
/// (see EdgeSE2Segment2DLine). Error: (x⁻¹ sₖ − (x, y), wrap(∠n − θ)). Tag: EDGE_SE2_SEGMENT2D_POINTLINE.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeSE2Segment2DPointLine
    : public ReadyMadeEdge<EdgeSE2Segment2DPointLine, 3, Vector3, VertexSE2, VertexSegment2D> {
 public:
  EdgeSE2Segment2DPointLine();

  Vector2 point() const { return _measurement.head<2>(); }
  double theta() const { return _measurement[2]; }
  void setPoint(const Vector2& p) { _measurement.head<2>() = p; }
  void setTheta(double theta) { _measurement[2] = theta; }
  /// Which end point is measured: 0 or 1.
  int pointNum() const { return _pointNum; }
  void setPointNum(int pointNum) { _pointNum = pointNum; }

 protected:
  int _pointNum = 0;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_SEGMENT2D_POINTLINE_H
