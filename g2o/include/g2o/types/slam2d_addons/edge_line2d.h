// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_LINE2D_H
#define G2O_EDGE_LINE2D_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam2d_addons/vertex_line2d.h"

namespace g2o {

/// The measured difference z of two lines. Error: (wrap(θ₂ − θ₁ − θ), ρ₂ − ρ₁ − ρ) for z = (θ, ρ). Tag:
/// EDGE_LINE2D.
class G2O_TYPES_SLAM2D_ADDONS_API EdgeLine2D : public BaseBinaryEdge<2, Line2D, VertexLine2D, VertexLine2D> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeLine2D();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<2, Line2D, VertexLine2D, VertexLine2D>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 2; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
};

}  // namespace g2o

#endif  // G2O_EDGE_LINE2D_H
