// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_EDGESBACAM_H
#define G2O_SBA_EDGESBACAM_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/sba/vertex_cam.h"

namespace g2o {

/// The measured motion z from a camera c₁ to a camera c₂. Error: the translation of z⁻¹ c₁⁻¹ c₂ and the
/// vector part of its unit quaternion with w ≥ 0. Tag: EDGE_CAM.
class G2O_TYPES_SBA_API EdgeSBACam : public BaseBinaryEdge<6, SE3Quat, VertexCam, VertexCam> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgeSBACam();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<6, SE3Quat, VertexCam, VertexCam>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;
  void setMeasurement(const SE3Quat& meas) override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 7; }
  bool setMeasurementFromState() override;

  double initialEstimatePossible(const OptimizableGraph::VertexSet& from,
                                 OptimizableGraph::Vertex* to) override;
  /// Does not change the camera matrix of `to`.
  void initialEstimate(const OptimizableGraph::VertexSet& from, OptimizableGraph::Vertex* to) override;

 protected:
  SE3Quat _inverseMeasurement;
};

}  // namespace g2o

#endif  // G2O_SBA_EDGESBACAM_H
