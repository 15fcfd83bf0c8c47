// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_POINTXY_H
#define G2O_EDGE_POINTXY_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"

namespace g2o {

/// The measured difference z between the points p₂ and p₁. Error: (p₂ − p₁) − z. Tag: EDGE_POINTXY.
class G2O_TYPES_SLAM2D_API EdgePointXY
    : public ReadyMadeEdge<EdgePointXY, 2, Vector2, VertexPointXY, VertexPointXY> {
 public:
  EdgePointXY();
};

}  // namespace g2o

#endif  // G2O_EDGE_POINTXY_H
