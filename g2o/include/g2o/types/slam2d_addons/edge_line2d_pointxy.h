// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_LINE2D_POINTXY_H
#define G2O_EDGE_LINE2D_POINTXY_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"

namespace g2o {

/// The measured distance z of a point p from a line, along the normal n of the line. Error: n·p − ρ − z. Tag:
/// EDGE_LINE2D_POINTXY.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeLine2DPointXY
    : public ReadyMadeEdge<EdgeLine2DPointXY, 1, double, VertexLine2D, VertexPointXY> {
 public:
  EdgeLine2DPointXY();
};

}  // namespace g2o

#endif  // G2O_EDGE_LINE2D_POINTXY_H
