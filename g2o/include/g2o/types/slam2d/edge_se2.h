// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_H
#define G2O_EDGE_SE2_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/se2.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured motion z from a pose x₁ to a pose x₂. Error: (x, y, θ) of z⁻¹ x₁⁻¹ x₂. Tag: EDGE_SE2.
class G2O_TYPES_SLAM2D_API EdgeSE2 : public ReadyMadeEdge<EdgeSE2, 3, SE2, VertexSE2, VertexSE2> {
 public:
  EdgeSE2();
};

/// The action "writeGnuplot" of EdgeSE2.
class G2O_TYPES_SLAM2D_API EdgeSE2WriteGnuplotAction : public internal::NamedAction<WriteGnuplotAction> {
 public:
  EdgeSE2WriteGnuplotAction();
};

/// The action "draw" of EdgeSE2.
class G2O_TYPES_SLAM2D_API EdgeSE2DrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2DrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_H
