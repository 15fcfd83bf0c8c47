// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_LINE2D_H
#define G2O_EDGE_SE2_LINE2D_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"

namespace g2o {

/// The measured line z in the frame of a pose x. Error: x⁻¹ line − z, with the angle wrapped. Tag:
/// EDGE_SE2_LINE2D.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeSE2Line2D
    : public ReadyMadeEdge<EdgeSE2Line2D, 2, Line2D, VertexSE2, VertexLine2D> {
 public:
  EdgeSE2Line2D();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_LINE2D_H
