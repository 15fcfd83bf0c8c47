// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SIM_3
#define G2O_SIM_3

#include <cassert>
#include <ostream>

#include "g2o/types/sim3/g2o_types_sim3_api.h"
#include "g2o/types/slam3d/se3quat.h"

namespace g2o {

/// A similarity of space: p ↦ s R p + t with s > 0. R is stored as a unit quaternion with w ≥ 0.
struct G2O_TYPES_SIM3_API Sim3 {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

 protected:
  Quaternion r;
  Vector3 t;
  double s;

 public:
  Sim3() : r(Quaternion::Identity()), t(0, 0, 0), s(1) {}
  Sim3(const Quaternion& r_, const Vector3& t_, double s_) : r(r_), t(t_), s(s_) { normalizeRotation(); }
  Sim3(const Matrix3& R, const Vector3& t_, double s_) : r(R), t(t_), s(s_) { normalizeRotation(); }
  /// Computes the exponential of (ω, υ, σ). ω is the rotation vector, υ is the translational part of the
  /// tangent vector, and σ is the logarithm of the scale.
  Sim3(const Vector7& update);  // NOLINT: older clients rely on the implicit conversion

  Vector3 map(const Vector3& xyz) const { return s * (r * xyz) + t; }
  /// Returns (ω, υ, σ), whose exponential is this similarity.
  Vector7 log() const;
  Sim3 inverse() const {
    const Quaternion conjugate = r.conjugate();
    return Sim3(conjugate, conjugate * Vector3((-1 / s) * t), 1 / s);
  }

  /// Access to the elements, in the order qx qy qz qw x y z s.
  double operator[](int i) const {
    assert(i >= 0 && i < 8);
    return i < 4 ? r.coeffs()[i] : i < 7 ? t[i - 4] : s;
  }
  double& operator[](int i) {
    assert(i >= 0 && i < 8);
    return i < 4 ? r.coeffs()[i] : i < 7 ? t[i - 4] : s;
  }

  Sim3 operator*(const Sim3& other) const { return Sim3(r * other.r, s * (r * other.t) + t, s * other.s); }
  Sim3& operator*=(const Sim3& other) { return *this = *this * other; }

  void normalizeRotation() {
    if (r.w() < 0) r.coeffs() *= -1;
    r.normalize();
  }

  const Vector3& translation() const { return t; }
  Vector3& translation() { return t; }
  const Quaternion& rotation() const { return r; }
  Quaternion& rotation() { return r; }
  const double& scale() const { return s; }
  double& scale() { return s; }
};

inline std::ostream& operator<<(std::ostream& os, const Sim3& sim3) {
  return os << sim3.rotation().coeffs().transpose() << '\n'
            << sim3.translation().transpose() << '\n'
            << sim3.scale() << '\n';
}

}  // namespace g2o

#endif  // G2O_SIM_3
