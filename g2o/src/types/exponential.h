// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of exp(δ) x with respect to δ at δ = 0, with δ = (ω, υ) or (ω, υ, σ).
#pragma once

#include "boxplus/autodiff/dual.h"
#include "boxplus/manifold/sim3.h"
#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/se3quat.h"

namespace g2o {
namespace adapters {

inline boxplus::Sim3 similarity(const Quaternion& r, const Vector3& t, double s) {
  return boxplus::Sim3::from_unit({r.x(), r.y(), r.z(), r.w()}, t, s);
}

/// ∂ log(exp(δ) x)/∂δ.
inline Matrix7 left_jacobian_of_log(const boxplus::Sim3& x) {
  using S = boxplus::detail::Dual<double, 7>;
  boxplus::Vector<S, 7> delta;
  for (int i = 0; i < 7; ++i) delta[i] = S::variable(0, i);
  const boxplus::Vector<S, 7> log = (boxplus::BasicSim3<S>::exp(delta) * x.cast<S>()).log();
  Matrix7 J;
  for (int i = 0; i < 7; ++i) {
    for (int k = 0; k < 7; ++k) J(i, k) = log[i].derivative[k];
  }
  return J;
}
inline Matrix6 left_jacobian_of_log(const SE3Quat& x) {
  return left_jacobian_of_log(similarity(x.rotation(), x.translation(), 1)).topLeftCorner<6, 6>();
}

}  // namespace adapters
}  // namespace g2o
