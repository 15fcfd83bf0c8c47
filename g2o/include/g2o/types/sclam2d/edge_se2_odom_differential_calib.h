// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H
#define G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H

#include "g2o/core/base_fixed_sized_edge.h"
#include "g2o/types/sclam2d/odometry_measurement.h"
#include "g2o/types/sclam2d/vertex_odom_differential_params.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The speeds of the wheels between two poses x₁ and x₂. The parameters k of the wheels are a vertex, too.
/// Vertices: x₁, x₂, k. Error: (x, y, θ) of U⁻¹ x₁⁻¹ x₂, where U is the motion along the arc that wheels with
/// these parameters drive. Tag: EDGE_SE2_ODOM_DIFFERENTIAL_CALIB.
class G2O_TYPES_SCLAM2D_API EdgeSE2OdomDifferentialCalib
    : public BaseFixedSizedEdge<3, VelocityMeasurement, VertexSE2, VertexSE2, VertexOdomDifferentialParams> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2OdomDifferentialCalib();

  void computeError() override;
  void linearizeOplus() override;
  using BaseFixedSizedEdge<3, VelocityMeasurement, VertexSE2, VertexSE2,
                           VertexOdomDifferentialParams>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// The speeds of the left and right wheel, and dt.
  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 3; }

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
};

/// The action "draw" of EdgeSE2OdomDifferentialCalib.
class G2O_TYPES_SCLAM2D_API EdgeSE2OdomDifferentialCalibDrawAction
    : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2OdomDifferentialCalibDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_ODOM_DIFFERENTIAL_CALIB_H
