// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_POINT_XY_H
#define G2O_EDGE_SE2_POINT_XY_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a pose x. Error: x⁻¹ l − z. Tag: EDGE_SE2_XY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXY
    : public ReadyMadeEdge<EdgeSE2PointXY, 2, Vector2, VertexSE2, VertexPointXY> {
 public:
  EdgeSE2PointXY();
};

/// The action "writeGnuplot" of EdgeSE2PointXY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  EdgeSE2PointXYWriteGnuplotAction();
};

/// The action "draw" of EdgeSE2PointXY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2PointXYDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_POINT_XY_H
