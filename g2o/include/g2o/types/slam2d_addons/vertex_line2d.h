// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_LINE_2D_H
#define G2O_VERTEX_LINE_2D_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam2d_addons/line_2d.h"

namespace g2o {

/// An infinite line in the plane. ⊞ adds (Δθ, Δρ). Tag: VERTEX_LINE2D.
class G2O_TYPES_SLAM2D_ADDONS_API VertexLine2D : public BaseVertex<2, Line2D> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  using UsedByEdges = VertexLine2D;
  VertexLine2D();

  double theta() const { return _estimate[0]; }
  void setTheta(double theta) { _estimate[0] = theta; }
  double rho() const { return _estimate[1]; }
  void setRho(double rho) { _estimate[1] = rho; }

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 2; }
  bool getMinimalEstimateData(double* est) const override { return getEstimateData(est); }
  int minimalEstimateDimension() const override { return 2; }
  using BaseVertex<2, Line2D>::getEstimateData;
  using BaseVertex<2, Line2D>::getMinimalEstimateData;

  /// The ids of two points (VertexPointXY) between which the line is drawn; −1 if there is none.
  int p1Id = -1, p2Id = -1;

 protected:
  void setToOriginImpl() override { _estimate = Line2D(); }
  using BaseVertex<2, Line2D>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
  bool setMinimalEstimateDataImpl(const double* est) override { return setEstimateDataImpl(est); }
};

/// The action "draw" of VertexLine2D.
class G2O_TYPES_SLAM2D_ADDONS_API VertexLine2DDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexLine2DDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_LINE_2D_H
