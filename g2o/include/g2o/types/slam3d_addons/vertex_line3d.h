// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_LINE3D_H_
#define G2O_VERTEX_LINE3D_H_

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam3d_addons/line3d.h"

namespace g2o {

/// A line in space, and the color in which it is drawn. ⊞ is Line3D::oplus(). Tag: VERTEX_LINE3D.
class G2O_TYPES_SLAM3D_ADDONS_API VertexLine3D : public BaseVertex<4, Line3D> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexLine3D();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// The six Plücker coordinates of the line.
  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 6; }
  using BaseVertex<4, Line3D>::getEstimateData;

  Vector3 color = Vector3(1, 0.5, 0);  ///< red, green, blue in [0, 1]; not saved in files

 protected:
  void setToOriginImpl() override { _estimate = Line3D(); }
  using BaseVertex<4, Line3D>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
};

/// The action "draw" of VertexLine3D.
class G2O_TYPES_SLAM3D_ADDONS_API VertexLine3DDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexLine3DDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_LINE3D_H_
