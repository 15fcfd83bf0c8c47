// SPDX-License-Identifier: BSD-3-Clause
// The derivatives of the exponential and the logarithm of rotations, as functions of a rotation vector φ
// (radians).
#pragma once

#include <cmath>

#include "boxplus/manifold/so3.h"
#include "boxplus/types/slam3d/between_jacobians.h"

namespace boxplus::detail {

/// a I + b [φ]× + c [φ]×².
inline Matrix<double, 3, 3> rotation_polynomial(const Vector3& phi, double a, double b, double c) {
  const double x = phi[0], y = phi[1], z = phi[2];
  Matrix<double, 3, 3> m;
  m << a - c * (y * y + z * z), c * x * y - b * z, c * x * z + b * y,  //
      c * x * y + b * z, a - c * (x * x + z * z), c * y * z - b * x,   //
      c * x * z - b * y, c * y * z + b * x, a - c * (x * x + y * y);
  return m;
}

/// J_r(φ), with Exp(φ + δ) ≈ Exp(φ) Exp(J_r(φ) δ) (Forster et al. 2017, eq. 8).
inline Matrix<double, 3, 3> right_jacobian(const Vector3& phi) {
  const double t = phi.squaredNorm();
  if (t < kSmallSquaredAngle) {
    return rotation_polynomial(phi, 1, -(1.0 / 2 - t * (1.0 / 24 - t * (1.0 / 720 - t / 40320))),
                               1.0 / 6 - t * (1.0 / 120 - t * (1.0 / 5040)));
  }
  const double angle = std::sqrt(t), sine = std::sin(0.5 * angle);
  return rotation_polynomial(phi, 1, -2 * sine * sine / t, (1 - std::sin(angle) / angle) / t);
}

/// J_r(φ)⁻¹, with Log(Exp(φ) Exp(δ)) ≈ φ + J_r(φ)⁻¹ δ (Forster et al. 2017, eq. 9), for |φ| ≤ π. Its
/// transpose is J_l(φ)⁻¹, with Log(Exp(δ) Exp(φ)) ≈ φ + J_l(φ)⁻¹ δ.
inline Matrix<double, 3, 3> inverse_right_jacobian(const Vector3& phi) {
  const double t = phi.squaredNorm();
  if (t < kSmallSquaredAngle) {
    return rotation_polynomial(phi, 1, 0.5, 1.0 / 12 + t * (1.0 / 720 + t * (1.0 / 30240)));
  }
  const double half = 0.5 * std::sqrt(t);
  return rotation_polynomial(phi, 1, 0.5, (1 - half * std::cos(half) / std::sin(half)) / t);
}

}  // namespace boxplus::detail
