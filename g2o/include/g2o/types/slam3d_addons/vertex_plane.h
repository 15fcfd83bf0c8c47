// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_PLANE_H_
#define G2O_VERTEX_PLANE_H_

#include "g2o/core/base_vertex.h"
#include "g2o/types/slam3d_addons/plane3d.h"

namespace g2o {

/// A plane, and the color in which it is drawn. ⊞ is Plane3D::oplus(). Tag: VERTEX_PLANE.
class G2O_TYPES_SLAM3D_ADDONS_API VertexPlane : public BaseVertex<3, Plane3D> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexPlane();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// The four coefficients of the plane.
  bool getEstimateData(double* est) const override;
  int estimateDimension() const override { return 4; }
  using BaseVertex<3, Plane3D>::getEstimateData;

  Vector3 color = Vector3(0.2, 0.2, 0.2);  ///< red, green, blue in [0, 1]

 protected:
  void setToOriginImpl() override { _estimate = Plane3D(); }
  using BaseVertex<3, Plane3D>::oplusImpl;
  void oplusImpl(double* update) override;
  bool setEstimateDataImpl(const double* est) override;
};

/// The action "draw" of VertexPlane.
class G2O_TYPES_SLAM3D_ADDONS_API VertexPlaneDrawAction : public internal::NamedAction<DrawAction> {
 public:
  VertexPlaneDrawAction();
};

}  // namespace g2o

#endif  // G2O_VERTEX_PLANE_H_
