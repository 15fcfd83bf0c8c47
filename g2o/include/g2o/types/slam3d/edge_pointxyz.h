// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_POINTXYZ_H
#define G2O_EDGE_POINTXYZ_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"

namespace g2o {

/// The measured difference z between the points p₂ and p₁. Error: (p₂ − p₁) − z. Tag: EDGE_POINTXYZ.
class G2O_TYPES_SLAM3D_API EdgePointXYZ : public BaseBinaryEdge<3, Vector3, VertexPointXYZ, VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgePointXYZ();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<3, Vector3, VertexPointXYZ, VertexPointXYZ>::linearizeOplus;
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

#endif  // G2O_EDGE_POINTXYZ_H
