// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_LINE2D_H
#define G2O_EDGE_LINE2D_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"

namespace g2o {

/// The measured difference z of two lines. Error: (wrap(θ₂ − θ₁ − θ), ρ₂ − ρ₁ − ρ) for z = (θ, ρ). Tag:
/// EDGE_LINE2D.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeLine2D
    : public ReadyMadeEdge<EdgeLine2D, 2, Line2D, VertexLine2D, VertexLine2D> {
 public:
  EdgeLine2D();
};

}  // namespace g2o

#endif  // G2O_EDGE_LINE2D_H
