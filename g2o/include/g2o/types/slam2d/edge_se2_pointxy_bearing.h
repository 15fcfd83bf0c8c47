// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_POINT_XY_BEARING_H
#define G2O_EDGE_SE2_POINT_XY_BEARING_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured bearing z (radians) of a landmark l in the frame of a pose x. Error: z minus the angle of the
/// vector x⁻¹ l, wrapped to (−π, π]. Tag: EDGE_BEARING_SE2_XY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYBearing
    : public ReadyMadeEdge<EdgeSE2PointXYBearing, 1, double, VertexSE2, VertexPointXY> {
 public:
  EdgeSE2PointXYBearing();
};

/// The action "writeGnuplot" of EdgeSE2PointXYBearing.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYBearingWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  EdgeSE2PointXYBearingWriteGnuplotAction();
};

/// The action "draw" of EdgeSE2PointXYBearing.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYBearingDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2PointXYBearingDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_POINT_XY_BEARING_H
