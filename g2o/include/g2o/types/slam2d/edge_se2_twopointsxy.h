// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_TWOPOINTSXY_H
#define G2O_EDGE_SE2_TWOPOINTSXY_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured positions z of two points p₁ and p₂ in the frame of a pose x, with correlated noise. Error:
/// (x⁻¹ p₁, x⁻¹ p₂) − z. Tag: EDGE_SE2_TWOPOINTSXY.
class G2O_TYPES_SLAM2D_API EdgeSE2TwoPointsXY
    : public ReadyMadeEdge<EdgeSE2TwoPointsXY, 4, Vector4, VertexSE2, VertexPointXY, VertexPointXY> {
 public:
  EdgeSE2TwoPointsXY();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_TWOPOINTSXY_H
