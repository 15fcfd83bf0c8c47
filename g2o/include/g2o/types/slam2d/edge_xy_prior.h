// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_XY_PRIOR_H
#define G2O_EDGE_XY_PRIOR_H

#include "g2o/core/base_unary_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"

namespace g2o {

/// A prior z for a point p. Error: p − z. Tag: EDGE_PRIOR_XY.
class G2O_TYPES_SLAM2D_API EdgeXYPrior : public BaseUnaryEdge<2, Vector2, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeXYPrior();

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
  using BaseUnaryEdge<2, Vector2, VertexPointXY>::linearizeOplus;
};

}  // namespace g2o

#endif  // G2O_EDGE_XY_PRIOR_H
