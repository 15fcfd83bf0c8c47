// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_TWOPOINTSXY_H
#define G2O_EDGE_SE2_TWOPOINTSXY_H

#include "g2o/core/base_fixed_sized_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured positions z of two points p₁ and p₂ in the frame of a pose x, with correlated noise. Error:
/// (x⁻¹ p₁, x⁻¹ p₂) − z. Tag: EDGE_SE2_TWOPOINTSXY.
class G2O_TYPES_SLAM2D_API EdgeSE2TwoPointsXY
    : public BaseFixedSizedEdge<4, Vector4, VertexSE2, VertexPointXY, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2TwoPointsXY();

  void computeError() override;
  void linearizeOplus() override;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 4; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
  using BaseFixedSizedEdge<4, Vector4, VertexSE2, VertexPointXY, VertexPointXY>::linearizeOplus;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_TWOPOINTSXY_H
