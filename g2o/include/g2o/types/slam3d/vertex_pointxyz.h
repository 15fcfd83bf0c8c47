// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_TRACKXYZ_H_
#define G2O_VERTEX_TRACKXYZ_H_

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam3d/g2o_types_slam3d_api.h"

namespace g2o {

/// A point in space. Tag: VERTEX_TRACKXYZ.
class G2O_TYPES_SLAM3D_API VertexPointXYZ : public BaseVertex<3, Vector3> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPointXYZ();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 3; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 3; }
  using BaseVertex<3, Vector3>::getEstimateData;
  using BaseVertex<3, Vector3>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate.setZero(); }
  using BaseVertex<3, Vector3>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

/// The action "writeGnuplot" of VertexPointXYZ.
class G2O_TYPES_SLAM3D_API VertexPointXYZWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  VertexPointXYZWriteGnuplotAction();
};

/// The action "draw" of VertexPointXYZ.
class G2O_TYPES_SLAM3D_API VertexPointXYZDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexPointXYZDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_TRACKXYZ_H_
