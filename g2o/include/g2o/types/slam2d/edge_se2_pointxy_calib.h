// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_POINT_XY_CALIB_H
#define G2O_EDGE_SE2_POINT_XY_CALIB_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a sensor. The vertices are the pose x of the
/// robot, the landmark, and the pose c of the sensor on the robot. Error: (x c)⁻¹ l − z. Tag:
/// EDGE_SE2_XY_CALIB.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYCalib
    : public ReadyMadeEdge<EdgeSE2PointXYCalib, 2, Vector2, VertexSE2, VertexPointXY, VertexSE2> {
 public:
  EdgeSE2PointXYCalib();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_POINT_XY_CALIB_H
