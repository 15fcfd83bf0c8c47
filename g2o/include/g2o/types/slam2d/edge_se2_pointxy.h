// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE2_POINT_XY_H
#define G2O_EDGE_SE2_POINT_XY_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam2d/vertex_point_xy.h"
#include "g2o/types/slam2d/vertex_se2.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a pose x. Error: x⁻¹ l − z. Tag: EDGE_SE2_XY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXY : public BaseBinaryEdge<2, Vector2, VertexSE2, VertexPointXY> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE2PointXY();

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
  using BaseBinaryEdge<2, Vector2, VertexSE2, VertexPointXY>::linearizeOplus;
};

/// The action "writeGnuplot" of EdgeSE2PointXY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  EdgeSE2PointXYWriteGnuplotAction();
};

/// The action "draw" of EdgeSE2PointXY.
class G2O_TYPES_SLAM2D_API EdgeSE2PointXYDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE2PointXYDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE2_POINT_XY_H
