// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SE2_H
#define G2O_VERTEX_SE2_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam2d/se2.h"

namespace g2o {

/// A pose in the plane. ⊞ adds (Δx, Δy, Δθ) in the world frame. Tag: VERTEX_SE2.
class G2O_TYPES_SLAM2D_API VertexSE2 : public BaseVertex<3, SE2> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSE2();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 3; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 3; }
  using BaseVertex<3, SE2>::getEstimateData;
  using BaseVertex<3, SE2>::getMinimalEstimateData;

 protected:
  void setToOriginImpl() override { _estimate = SE2(); }
  using BaseVertex<3, SE2>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

/// The action "writeGnuplot" of VertexSE2.
class G2O_TYPES_SLAM2D_API VertexSE2WriteGnuplotAction : public internal::NamedAction<WriteGnuplotAction> {
 public:
  VertexSE2WriteGnuplotAction();
};

/// The action "draw" of VertexSE2.
class G2O_TYPES_SLAM2D_API VertexSE2DrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexSE2DrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_SE2_H
