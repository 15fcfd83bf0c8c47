// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_LOTSOF_XYZ
#define G2O_EDGE_SE3_LOTSOF_XYZ

#include "g2o/core/base_variable_sized_edge.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured positions z of any number of points in the frame of a pose x, with correlated noise. The
/// first vertex is the pose, and the other vertices are the points pₖ. zₖ are the three entries of z for the
/// point pₖ. Error: x⁻¹ pₖ − zₖ for all k. Tag: EDGE_SE3_LOTSOF_XYZ.
class G2O_TYPES_SLAM3D_API EdgeSE3LotsOfXYZ : public BaseVariableSizedEdge<-1, VectorX> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3LotsOfXYZ();

  /// Sets the number of vertices, including the pose. Resizes the measurement and Ω if the number changes.
  void resize(size_t size) override;
  void setSize(int vertices);
  /// Also returns false if the number of points differs from the number of points in the measurement.
  bool verticesFit() const override;

  void computeError() override;
  void linearizeOplus() override;
  using BaseVariableSizedEdge<-1, VectorX>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return static_cast<int>(_measurement.size()); }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

 protected:
  unsigned int _observedPoints = 0;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_LOTSOF_XYZ
