// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_SE3_PRIOR_H_
#define G2O_EDGE_SE3_PRIOR_H_

#include "g2o/core/base_unary_edge.h"
#include "g2o/types/slam3d/parameter_se3_offset.h"
#include "g2o/types/slam3d/vertex_se3.h"

namespace g2o {

/// A prior z for the pose of a sensor in the world. x is the pose of the robot, and P is the pose of the
/// sensor on the robot. Error: the translation of z⁻¹ x P and the vector part of its unit quaternion with w ≥
/// 0. Tag: EDGE_SE3_PRIOR.
class G2O_TYPES_SLAM3D_API EdgeSE3Prior : public BaseUnaryEdge<6, Isometry3, VertexSE3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSE3Prior();

  void computeError() override;
  void linearizeOplus() override;
  using BaseUnaryEdge<6, Isometry3, VertexSE3>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
  void setMeasurement(const Isometry3& m) override;
  const ParameterSE3Offset* offsetParameter() const { return offsetParam; }

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 7; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

 protected:
  Isometry3 _inverseMeasurement;
  /// Finds _cache if the object belongs to a derived class. EdgeSE3Prior itself does not use it.
  bool resolveCaches() override;

  ParameterSE3Offset* offsetParam = nullptr;
  CacheSE3Offset* _cache = nullptr;  ///< set only in derived classes

 private:
  internal::RotationMemory rotation_;
};

}  // namespace g2o

#endif  // G2O_EDGE_SE3_PRIOR_H_
