// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_SEGMENT2D_LINE_H
#define G2O_EDGE_SE2_SEGMENT2D_LINE_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "g2o/types/slam2d_addons/vertex_segment2d.h"

namespace g2o {

/// The measured line (θ, ρ) through a segment s in the frame of a pose: the angle of its normal n (the
/// direction from s₁ to s₂, turned by −90°), and its distance along n. Error: (wrap(∠n − θ), n·(s₁ + s₂)/2 −
/// ρ), with s in the frame of the pose. Tag: EDGE_SE2_SEGMENT2D_LINE.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeSE2Segment2DLine
    : public ReadyMadeEdge<EdgeSE2Segment2DLine, 2, Vector2, VertexSE2, VertexSegment2D> {
 public:
  EdgeSE2Segment2DLine();

  double theta() const { return _measurement[0]; }
  double rho() const { return _measurement[1]; }
  void setTheta(double theta) { _measurement[0] = theta; }
  void setRho(double rho) { _measurement[1] = rho; }
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_SEGMENT2D_LINE_H
