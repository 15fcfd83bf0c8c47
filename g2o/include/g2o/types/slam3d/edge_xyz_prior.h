// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_XYZ_PRIOR_H_
#define G2O_EDGE_XYZ_PRIOR_H_

#include "g2o/core/base_unary_edge.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// A prior z for a point p. Error: p − z. Tag: EDGE_POINTXYZ_PRIOR.
class G2O_TYPES_SLAM3D_API EdgeXYZPrior : public BaseUnaryEdge<3, Vector3, VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeXYZPrior();

  void computeError() override;
  void linearizeOplus() override;
  using BaseUnaryEdge<3, Vector3, VertexPointXYZ>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 3; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
};

}  // namespace g2o

#endif  // G2O_EDGE_XYZ_PRIOR_H_
