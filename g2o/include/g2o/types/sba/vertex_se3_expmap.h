// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_VERTEXSE3EXPMAP_H
#define G2O_SBA_VERTEXSE3EXPMAP_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/sba/g2o_types_sba_api.h"
#include "g2o/types/slam3d/se3quat.h"

namespace g2o {

/// The transformation T from the world frame to the camera frame. T ⊞ (ω, υ) is exp(ω, υ) T. Files store T⁻¹.
/// Tag: VERTEX_SE3:EXPMAP.
class G2O_TYPES_SBA_API VertexSE3Expmap : public BaseVertex<6, SE3Quat> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSE3Expmap();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// The estimate data are x y z qx qy qz qw of T, and the minimal estimate data are x y z qx qy qz.
  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 7; }
  bool getMinimalEstimateData(double* est) const override;
  int minimalEstimateDimension() const override { return 6; }
  using BaseVertex<6, SE3Quat>::getEstimateData;
  using BaseVertex<6, SE3Quat>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate = SE3Quat(); }
  using BaseVertex<6, SE3Quat>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override;
};

}  // namespace g2o

#endif  // G2O_SBA_VERTEXSE3EXPMAP_H
