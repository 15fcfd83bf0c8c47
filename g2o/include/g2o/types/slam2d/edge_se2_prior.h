// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_PRIOR_H
#define G2O_EDGE_SE2_PRIOR_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/se2.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// A prior z for a pose x. Error: (x, y, θ) of z⁻¹ x. Tag: EDGE_PRIOR_SE2.
class G2O_TYPES_SLAM2D_API EdgeSE2Prior : public ReadyMadeEdge<EdgeSE2Prior, 3, SE2, VertexSE2> {
 public:
  EdgeSE2Prior();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_PRIOR_H
