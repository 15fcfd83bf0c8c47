// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBA_VERTEXCAM_H
#define G2O_SBA_VERTEXCAM_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/sba/sbacam.h"

namespace g2o {

/// A camera with a known camera matrix. ⊞ is SBACam::update(). Tag: VERTEX_CAM.
class G2O_TYPES_SBA_API VertexCam : public BaseVertex<6, SBACam> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexCam();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// Also updates the members of SBACam that depend on the pose.
  void setEstimate(const SBACam& cam);

  /// The estimate data are x y z qx qy qz qw, and the minimal estimate data are x y z qx qy qz. They do not
  /// include the camera matrix.
  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 7; }
  bool getMinimalEstimateData(double* est) const override;
  int minimalEstimateDimension() const override { return 6; }
  using BaseVertex<6, SBACam>::getEstimateData;
  using BaseVertex<6, SBACam>::getMinimalEstimateData;

 protected:
  /// Does not change the camera matrix.
  void setToOriginImpl() override;
  using BaseVertex<6, SBACam>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override;
};

}  // namespace g2o

#endif  // G2O_SBA_VERTEXCAM_H
