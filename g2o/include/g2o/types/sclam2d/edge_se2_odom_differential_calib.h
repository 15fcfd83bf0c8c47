// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H
#define G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H

#include "g2o/core/ready_made_edge.h"
#include "g2o/types/sclam2d/odometry_measurement.h"
#include "g2o/types/sclam2d/vertex_odom_differential_params.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The speeds of the wheels between two poses x₁ and x₂. The parameters k of the wheels are a vertex, too.
/// Vertices: x₁, x₂, k. Error: (x, y, θ) of U⁻¹ x₁⁻¹ x₂, where U is the motion along the arc that wheels with
/// these parameters drive. Tag: EDGE_SE2_ODOM_DIFFERENTIAL_CALIB.
/// The measurement data are the speeds of the left and right wheel, and dt.
class G2O_TYPES_SCLAM2D_API EdgeSE2OdomDifferentialCalib
    : public ReadyMadeEdge<EdgeSE2OdomDifferentialCalib, 3, VelocityMeasurement, VertexSE2, VertexSE2,
                           VertexOdomDifferentialParams> {
 public:
  EdgeSE2OdomDifferentialCalib();
};

/// The action "draw" of EdgeSE2OdomDifferentialCalib.
class G2O_TYPES_SCLAM2D_API EdgeSE2OdomDifferentialCalibDrawAction
    : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2OdomDifferentialCalibDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H
