// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SE3_
#define G2O_VERTEX_SE3_

#include <vector>

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam3d/isometry3d_mappings.h"
#include "g2o/types/slam3d/rotation_memory.h"

namespace g2o {

/// A pose in space. ⊞ multiplies the pose by the motion (Δt, q_v) from the right. q_v is the vector part of a
/// unit quaternion. Tag: VERTEX_SE3:QUAT.
class G2O_TYPES_SLAM3D_API VertexSE3 : public BaseVertex<6, Isometry3> {
 public:
  using UsedByEdges = VertexSE3;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSE3();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  void push() override;
  void pop() override;
  void discardTop() override;

  /// The estimate is x y z qx qy qz qw (minimal: x y z qx qy qz).
  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 7; }
  bool getMinimalEstimateData(double* est) const override;
  int minimalEstimateDimension() const override { return 6; }
  using BaseVertex<6, Isometry3>::getEstimateData;
  using BaseVertex<6, Isometry3>::getMinimalEstimateData;

  SE3Quat estimateAsSE3Quat() const { return internal::toSE3Quat(estimate()); }
  void setEstimateFromSE3Quat(const SE3Quat& se3) { setEstimate(internal::fromSE3Quat(se3)); }

  /// The quaternion of the estimate. See internal::RotationMemory.
  internal::RotationMemory::Coefficients quaternion() const { return rotation_.get(_estimate); }

 protected:
  void setToOriginImpl() override { _estimate.setIdentity(); }
  using BaseVertex<6, Isometry3>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override;

 private:
  internal::RotationMemory rotation_;
  std::vector<internal::RotationMemory> rotation_backup_;
};

/// The action "writeGnuplot" of VertexSE3.
class G2O_TYPES_SLAM3D_API VertexSE3WriteGnuplotAction : public internal::NamedAction<WriteGnuplotAction> {
 public:
  VertexSE3WriteGnuplotAction();
};

/// The action "draw" of VertexSE3.
class G2O_TYPES_SLAM3D_API VertexSE3DrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexSE3DrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_SE3_
