// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_XY_PRIOR_H
#define G2O_EDGE_SE2_XY_PRIOR_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// A prior z for the position of a pose x. Error: t − z, with the translation t of x. Tag: EDGE_PRIOR_SE2_XY.
class G2O_TYPES_SLAM2D_API EdgeSE2XYPrior : public ReadyMadeEdge<EdgeSE2XYPrior, 2, Vector2, VertexSE2> {
 public:
  EdgeSE2XYPrior();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_XY_PRIOR_H
