// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_POINT_XY_OFFSET_H_
#define G2O_EDGE_SE2_POINT_XY_OFFSET_H_

#include <array>

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/slam2d/parameter_se2_offset.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a sensor. x is the pose of the robot, and P is the
/// pose of the sensor on the robot. Error: (x P)⁻¹ l − z. Tag: EDGE_SE2_POINTXY_OFFSET.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYOffset
    : public ReadyMadeEdge<EdgeSE2PointXYOffset, 2, Vector2, VertexSE2, VertexPointXY> {
 public:
  EdgeSE2PointXYOffset();
  friend struct internal::EdgeModel<EdgeSE2PointXYOffset>;

 protected:
  std::array<ParameterSE2Offset*, 1> _offsets{};
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_POINT_XY_OFFSET_H_
