// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_EDGE_PLANE_H
#define G2O_EDGE_PLANE_H

#include "g2o/core/base_binary_edge.h"
#include "g2o/types/slam3d_addons/vertex_plane.h"

namespace g2o {

/// The measured difference z between the coefficients of two planes.
/// Error: (coefficients₂ − coefficients₁) − z. Tag: EDGE_PLANE.
class G2O_TYPES_SLAM3D_ADDONS_API EdgePlane : public BaseBinaryEdge<4, Vector4, VertexPlane, VertexPlane> {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  EdgePlane();

  void computeError() override;
  void linearizeOplus() override;
  using BaseBinaryEdge<4, Vector4, VertexPlane, VertexPlane>::linearizeOplus;
  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  bool setMeasurementData(const double* d) override;
  bool getMeasurementData(double* d) const override;
  int measurementDimension() const override { return 4; }
  bool setMeasurementFromState() override;
};

}  // namespace g2o

#endif  // G2O_EDGE_PLANE_H
