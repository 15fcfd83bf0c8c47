// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_SENSOR_CALIB_H
#define G2O_EDGE_SE2_SENSOR_CALIB_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sclam2d/g2o_types_sclam2d_api.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The motion z of a sensor between two robot poses x₁ and x₂. The pose l of the sensor on the robot is a
/// vertex, too. Vertices: x₁, x₂, l. Error: (x, y, θ) of z⁻¹ (x₁ l)⁻¹ (x₂ l). Tag: EDGE_SE2_CALIB.
class G2O_TYPES_SCLAM2D_API EdgeSE2SensorCalib
    : public ReadyMadeEdge<EdgeSE2SensorCalib, 3, SE2, VertexSE2, VertexSE2, VertexSE2> {
 public:
  EdgeSE2SensorCalib();
};

/// The action "draw" of EdgeSE2SensorCalib.
class G2O_TYPES_SCLAM2D_API EdgeSE2SensorCalibDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2SensorCalibDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_SENSOR_CALIB_H
