// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_POINT_XYZ_H_
#define G2O_EDGE_SE3_POINT_XYZ_H_

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_pointxyz.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// The measured position z of a landmark l in the frame of a sensor. x is the pose of the robot, and P is the
/// pose of the sensor on the robot. Error: (x P)⁻¹ l − z. Tag: EDGE_SE3_TRACKXYZ.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZ : public BaseBinaryEdge<3, Vector3, VertexSE3, VertexPointXYZ> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3PointXYZ();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<3, Vector3, VertexSE3, VertexPointXYZ>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 3; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

 protected:
  ParameterSE3Offset* offsetParam = nullptr;
};

/// The action "draw" of EdgeSE3PointXYZ.
class G2O_TYPES_SLAM3D_API EdgeSE3PointXYZDrawAction : public internal::NamedAction<DrawAction> {
 public:
  EdgeSE3PointXYZDrawAction();
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_POINT_XYZ_H_
