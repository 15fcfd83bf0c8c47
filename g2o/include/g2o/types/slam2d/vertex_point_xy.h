// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_POINT_XY_H
#define G2O_VERTEX_POINT_XY_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam2d/g2o_types_slam2d_api.h"

namespace g2o {

/// A point in the plane. Tag: VERTEX_XY.
class G2O_TYPES_SLAM2D_API VertexPointXY : public BaseVertex<2, Vector2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPointXY();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 2; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 2; }
  using BaseVertex<2, Vector2>::getEstimateData;
  using BaseVertex<2, Vector2>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate.setZero(); }
  using BaseVertex<2, Vector2>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

/// The action "writeGnuplot" of VertexPointXY.
class G2O_TYPES_SLAM2D_API VertexPointXYWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  VertexPointXYWriteGnuplotAction();
};

/// The action "draw" of VertexPointXY.
class G2O_TYPES_SLAM2D_API VertexPointXYDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexPointXYDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_POINT_XY_H
