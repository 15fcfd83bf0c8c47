// SPDX-License-Identifier: BSD-3-Clause
// Derivatives of e = (t_D, s·v_D), D = Z⁻¹ A, A = Xi⁻¹ Xj, through ⊞ of SE3 in the quaternion chart.
//
// A rotation is written as the quaternion (v, w); s is the sign of w_D. A step δ = (Δt, u) is the motion with
// the quaternion (u, √(1 − |u|²)) ≈ (u, 1), which turns a point p to p + 2 u × p.
//   Xj ⊞ δ:  t: t_D + R_D Δt
//            q: q_D (u, 1) has the vector v_D + w_D u + v_D × u
//      ⇒ J_j = [ R_D  0 ;  0  s (w_D I + [v_D]×) ]
//   Xi ⊞ δ:  D = Z⁻¹ δ⁻¹ A
//            t: R_Zᵀ (t_A − Δt + 2 t_A × u − t_Z)
//            q: −q_Z* (u, 0) q_A, with (u, 0) q_A = (w_A u − v_A × u, −v_Aᵀ u)
//      ⇒ J_i = [ −R_Zᵀ  2 R_Zᵀ [t_A]× ;  0  −s ((w_Z I − [v_Z]×)(w_A I − [v_A]×) + v_Z v_Aᵀ) ]
#pragma once

#include "boxplus/manifold/se3.h"

namespace boxplus::detail {

/// [v]×, the matrix of the cross product with v.
inline Matrix<double, 3, 3> cross_matrix(double x, double y, double z) {
  Matrix<double, 3, 3> m;
  m << 0, -z, y, z, 0, -x, -y, x, 0;
  return m;
}

template <class A, class B>
void between_jacobians(const SE3& z, const SE3& xi, const SE3& xj, A& J_i, B& J_j) {
  const SE3 a = xi.inverse_times(xj);
  const Quaternion<double> qz = z.quaternion(), qa = a.quaternion(), qd = qz.conjugate() * qa;
  const double s = qd.w < 0 ? -1 : 1;
  const auto identity = Matrix<double, 3, 3>::Identity();
  const Matrix<double, 3, 3> RzT = z.rotation().transpose();
  const Vector3 ta = a.translation();

  J_i.template topLeftCorner<3, 3>() = -RzT;
  J_i.template topRightCorner<3, 3>() = 2 * RzT * cross_matrix(ta[0], ta[1], ta[2]);
  J_i.template bottomLeftCorner<3, 3>().setZero();
  J_i.template bottomRightCorner<3, 3>() =
      -s * ((qz.w * identity - cross_matrix(qz.x, qz.y, qz.z)) *
                (qa.w * identity - cross_matrix(qa.x, qa.y, qa.z)) +
            Vector3(qz.x, qz.y, qz.z) * Vector3(qa.x, qa.y, qa.z).transpose());

  J_j.template topLeftCorner<3, 3>() = rotation_matrix(qd);
  J_j.template topRightCorner<3, 3>().setZero();
  J_j.template bottomLeftCorner<3, 3>().setZero();
  J_j.template bottomRightCorner<3, 3>() = s * (qd.w * identity + cross_matrix(qd.x, qd.y, qd.z));
}

}  // namespace boxplus::detail
