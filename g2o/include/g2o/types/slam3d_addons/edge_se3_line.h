// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_LINE3D_H_
#define G2O_EDGE_SE3_LINE3D_H_

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"
#include "g2o/types/slam3d_addons/vertex_line3d.h"

namespace g2o {

/// A line z in the frame of a sensor. x is the pose of the robot, and P is the pose of the sensor on the
/// robot. Error: ((x P)⁻¹ line).ominus(z). Tag: EDGE_SE3_LINE3D.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Line3D : public BaseBinaryEdge<4, Line3D, VertexSE3, VertexLine3D> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3Line3D();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<4, Line3D, VertexSE3, VertexLine3D>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

  /// Sets the six Plücker coordinates of the line.
  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 6; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

  Vector3 color = Vector3(0, 0.5, 1);  ///< red, green, blue in [0, 1]; not saved in files

 protected:
  ParameterSE3Offset* offsetParam = nullptr;
};

/// The action "draw" of EdgeSE3Line3D.
class G2O_TYPES_SLAM3D_ADDONS_API EdgeSE3Line3DDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3Line3DDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_LINE3D_H_
