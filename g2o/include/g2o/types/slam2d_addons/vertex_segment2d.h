// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SEGMENT_2D_H
#define G2O_VERTEX_SEGMENT_2D_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam2d_addons/g2o_types_slam2d_addons_api.h"

namespace g2o {

/// The end points of a segment in the plane: x₁ y₁ x₂ y₂. ⊞ adds. Tag: VERTEX_SEGMENT2D.
class G2O_TYPES_SLAM2D_ADDONS_API VertexSegment2D : public BaseVertex<4, Vector4> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSegment2D();

  Vector2 estimateP1() const { return _estimate.head<2>(); }
  Vector2 estimateP2() const { return _estimate.tail<2>(); }
  void setEstimateP1(const Vector2& p) { _estimate.head<2>() = p; }
  void setEstimateP2(const Vector2& p) { _estimate.tail<2>() = p; }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 4; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 4; }
  using BaseVertex<4, Vector4>::getEstimateData;
  using BaseVertex<4, Vector4>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate.setZero(); }
  using BaseVertex<4, Vector4>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

/// The action "writeGnuplot" of VertexSegment2D.
class G2O_TYPES_SLAM2D_ADDONS_API VertexSegment2DWriteGnuplotAction
    : public internal::NamedAction<WriteGnuplotAction> {
 public:
  VertexSegment2DWriteGnuplotAction();
};

/// The action "draw" of VertexSegment2D.
class G2O_TYPES_SLAM2D_ADDONS_API VertexSegment2DDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexSegment2DDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_SEGMENT_2D_H
