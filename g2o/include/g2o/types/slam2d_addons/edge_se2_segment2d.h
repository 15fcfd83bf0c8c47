// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_SEGMENT2D_H
#define G2O_EDGE_SE2_SEGMENT2D_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "g2o/types/slam2d_addons/vertex_segment2d.h"

namespace g2o {

/// The measured end points of a segment s in the frame of a pose x. Error: (x⁻¹ s₁ − z₁, x⁻¹ s₂ − z₂). Tag:
/// EDGE_SE2_SEGMENT2D.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeSE2Segment2D
    : public ReadyMadeEdge<EdgeSE2Segment2D, 4, Vector4, VertexSE2, VertexSegment2D> {
 public:
  EdgeSE2Segment2D();

  Vector2 measurementP1() const { return _measurement.head<2>(); }
  Vector2 measurementP2() const { return _measurement.tail<2>(); }
  void setMeasurementP1(const Vector2& p) { _measurement.head<2>() = p; }
  void setMeasurementP2(const Vector2& p) { _measurement.tail<2>() = p; }
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_SEGMENT2D_H
