// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_XY_PRIOR_H
#define G2O_EDGE_XY_PRIOR_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"

namespace g2o {

/// A prior z for a point p. Error: p − z. Tag: EDGE_PRIOR_XY.
class G2O_TYPES_SLAM2D_API EdgeXYPrior : public ReadyMadeEdge<EdgeXYPrior, 2, Vector2, VertexPointXY> {
 public:
  EdgeXYPrior();
};

}  // namespace g2o

#endif  // G2O_EDGE_XY_PRIOR_H
