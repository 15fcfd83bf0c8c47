// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_POINTXY_H
#define G2O_EDGE_POINTXY_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"

namespace g2o {

/// The measured difference z between the points p₂ and p₁. Error: (p₂ − p₁) − z. Tag: EDGE_POINTXY.
class G2O_TYPES_SLAM2D_API EdgePointXY : public BaseBinaryEdge<2, Vector2, VertexPointXY, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgePointXY();

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
  using BaseBinaryEdge<2, Vector2, VertexPointXY, VertexPointXY>::linearizeOplus;
};

}  // namespace g2o

#endif  // G2O_EDGE_POINTXY_H
