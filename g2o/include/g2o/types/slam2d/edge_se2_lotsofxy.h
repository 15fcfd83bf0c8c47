// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_LOTSOF_XY_H
#define G2O_EDGE_SE2_LOTSOF_XY_H

#include "g2o/core/base_variable_sized_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured positions z of any number of points in the frame of a pose x, with correlated noise. The
/// first vertex is the pose, and the other vertices are the points pₖ. zₖ are the two entries of z for the
/// point pₖ. Error: x⁻¹ pₖ − zₖ for all k. Tag: EDGE_SE2_LOTSOFXY.
class G2O_TYPES_SLAM2D_API EdgeSE2LotsOfXY : public BaseVariableSizedEdge<-1, VectorX> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2LotsOfXY();

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

#endif  // G2O_EDGE_SE2_LOTSOF_XY_H
