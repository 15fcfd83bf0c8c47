// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_VERTEX_SIM3_EXPMAP_H
#define G2O_VERTEX_SIM3_EXPMAP_H

#include "g2o/core/base_vertex.h"
#include "g2o/types/sim3/sim3.h"

namespace g2o {

/// The similarity S from the world frame to a camera frame, and the intrinsics of two cameras. S ⊞ (ω, υ, σ)
/// is exp(ω, υ, σ) S. Files store the logarithm of S⁻¹, then the intrinsics. Tag: VERTEX_SIM3:EXPMAP.
class G2O_TYPES_SIM3_API VertexSim3Expmap : public BaseVertex<7, Sim3> {
 public:
  using UsedByEdges = VertexSim3Expmap;
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VertexSim3Expmap();

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// Return the image position (pixels) of the point (v, 1) in the frame of the first or second camera.
  Vector2 cam_map1(const Vector2& v) const { return v.cwiseProduct(_focal_length1) + _principle_point1; }
  Vector2 cam_map2(const Vector2& v) const { return v.cwiseProduct(_focal_length2) + _principle_point2; }

  Vector2 _principle_point1 = Vector2(0, 0), _principle_point2 = Vector2(0, 0);
  Vector2 _focal_length1 = Vector2(1, 1), _focal_length2 = Vector2(1, 1);
  bool _fix_scale = false;  ///< if true, ⊞ keeps the scale and ignores σ

 protected:
  void setToOriginImpl() override { _estimate = Sim3(); }
  using BaseVertex<7, Sim3>::oplusImpl;
  void oplusImpl(double* update) override;
};

}  // namespace g2o

#endif  // G2O_VERTEX_SIM3_EXPMAP_H
