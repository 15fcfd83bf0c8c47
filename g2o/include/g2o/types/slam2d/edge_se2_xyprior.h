// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_XY_PRIOR_H
#define G2O_EDGE_SE2_XY_PRIOR_H

#include "g2o/core/base_unary_edge.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// A prior z for the position of a pose x. Error: t − z, with the translation t of x. Tag: EDGE_PRIOR_SE2_XY.
class G2O_TYPES_SLAM2D_API EdgeSE2XYPrior : public BaseUnaryEdge<2, Vector2, VertexSE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2XYPrior();

  void computeError() override;
  void linearizeOplus() override;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 2; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
  using BaseUnaryEdge<2, Vector2, VertexSE2>::linearizeOplus;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_XY_PRIOR_H
