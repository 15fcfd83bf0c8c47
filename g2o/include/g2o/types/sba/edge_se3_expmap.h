// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESE3EXPMAP_H
#define G2O_SBA_EDGESE3EXPMAP_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/sba/vertex_se3_expmap.h"

namespace g2o {

/// The measured motion z from a camera T₁ to a camera T₂. Without noise, T₂ = z T₁. Error: log(T₂⁻¹ z T₁).
/// Files store z⁻¹. Tag: EDGE_SE3:EXPMAP.
class G2O_TYPES_SBA_API EdgeSE3Expmap : public BaseBinaryEdge<6, SE3Quat, VertexSE3Expmap, VertexSE3Expmap> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3Expmap();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<6, SE3Quat, VertexSE3Expmap, VertexSE3Expmap>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 7; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESE3EXPMAP_H
