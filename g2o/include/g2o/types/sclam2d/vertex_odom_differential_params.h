// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_ODOM_DIFFERENTIAL_PARAMS_H
#define G2O_VERTEX_ODOM_DIFFERENTIAL_PARAMS_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/sclam2d/g2o_types_sclam2d_api.h"

namespace g2o {

/// The factors on the speeds of the left and right wheel, and the distance between the wheels (meters). ⊞
/// adds. setToOrigin() sets (1, 1, 1). Tag: VERTEX_ODOM_DIFFERENTIAL.
class G2O_TYPES_SCLAM2D_API VertexOdomDifferentialParams : public BaseVertex<3, Vector3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexOdomDifferentialParams();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 3; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 3; }
  using BaseVertex<3, Vector3>::getEstimateData;
  using BaseVertex<3, Vector3>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate = Vector3(1, 1, 1); }
  using BaseVertex<3, Vector3>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

}  // namespace g2o

#endif  // G2O_VERTEX_ODOM_DIFFERENTIAL_PARAMS_H
