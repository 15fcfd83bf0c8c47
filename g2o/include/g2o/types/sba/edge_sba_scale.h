// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESBASCALE_H
#define G2O_SBA_EDGESBASCALE_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/sba/vertex_cam.h"

namespace g2o {

/// The measured distance z between two cameras. Error: z − |t₂ − t₁|, with the positions t₁ and t₂ of the
/// cameras. Tag: EDGE_SCALE.
class G2O_TYPES_SBA_API EdgeSBAScale : public BaseBinaryEdge<1, double, VertexCam, VertexCam> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSBAScale();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<1, double, VertexCam, VertexCam>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 1; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  /// Moves `to` along the line through both cameras, so that their distance becomes z.
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESBASCALE_H
