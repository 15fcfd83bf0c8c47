// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of e = (x, y, θ) of Z⁻¹ A, with A = Xi⁻¹ Xj, through ⊞ of SE2 (motion composition on the
// right).
//
// With R_Z the rotation of Z and (t_A, θ_A) the parts of A, the translation of e is R_Zᵀ (t_A − t_Z).
//   Xj ⊞ δ:  A · δ has the translation t_A + R_A Δt
//                                            ⇒ J_j = [ R_Zᵀ R_A  0 ;  0  1 ]
//   Xi ⊞ δ:  δ⁻¹ A has the translation R(Δθ)ᵀ (t_A − Δt)
//            ≈ t_A − Δt + Δθ (y_A, −x_A)
//                                            ⇒ J_i = [ −R_Zᵀ  R_Zᵀ (y_A, −x_A)ᵀ ;  0  −1 ]
#pragma once

#include "boxplus/manifold/se2.h"

namespace boxplus::detail {

template <class A, class B>
void between_jacobians(const SE2& z, const SE2& xi, const SE2& xj, A& J_i, B& J_j) {
  const SE2 a = xi.inverse_times(xj);
  const double cz = z.cos_theta(), sz = z.sin_theta();
  const double c = cz * a.cos_theta() + sz * a.sin_theta(), s = cz * a.sin_theta() - sz * a.cos_theta();
  J_i << -cz, -sz, cz * a.y() - sz * a.x(),  //
      sz, -cz, -sz * a.y() - cz * a.x(),     //
      0, 0, -1;
  J_j << c, -s, 0,  //
      s, c, 0,      //
      0, 0, 1;
}

}  // namespace boxplus::detail
