// SPDX-License-Identifier: BSD-3-Clause
// Rotations in space, stored as a unit quaternion.
#pragma once

#include <array>
#include <iosfwd>
#include <string_view>
#include <type_traits>

#include "boxplus/manifold/lift.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/rotation_charts.h"

namespace boxplus {

/// A rotation. Chart selects the tangent: QuaternionChart (vector part of the quaternion) or
/// RotationVectorChart. q and −q describe the same rotation; the object keeps the sign that it was given.
template <class S, class Chart = detail::QuaternionChart>
class BasicSO3 {
 public:
  using Scalar = S;
  using Quaternion = detail::Quaternion<S>;
  static constexpr std::string_view kName =
      std::is_same_v<Chart, detail::RotationVectorChart> ? "SO3RotationVector" : "SO3";

  /// The identity.
  BasicSO3() : coefficients_{S(0), S(0), S(0), S(1)} {}
  /// Normalizes q unless it is a unit quaternion up to rounding.
  explicit BasicSO3(const Quaternion& q) : BasicSO3(detail::normalized(q), Unit{}) {}
  explicit BasicSO3(const Matrix<S, 3, 3>& rotation) : BasicSO3(detail::quaternion_of(rotation)) {}

  /// q must be a unit quaternion.
  static BasicSO3 from_unit(const Quaternion& q) { return BasicSO3(q, Unit{}); }
  /// The rotation by |ω| radians around ω.
  template <class Derived>
  static BasicSO3 from_rotation_vector(const Eigen::MatrixBase<Derived>& omega) {
    return from_unit(detail::RotationVectorChart::exp(S(omega[0]), S(omega[1]), S(omega[2])));
  }

  Quaternion quaternion() const {
    return {coefficients_[0], coefficients_[1], coefficients_[2], coefficients_[3]};
  }
  Matrix<S, 3, 3> rotation() const { return detail::rotation_matrix(quaternion()); }
  Vector<S, 3> rotation_vector() const { return detail::RotationVectorChart::log(quaternion()); }
  /// The vector part of the quaternion with w ≥ 0.
  Vector<S, 3> minimal() const { return detail::QuaternionChart::log(quaternion()); }
  /// qx qy qz qw, contiguous.
  const S* data() const { return coefficients_.data(); }

  BasicSO3 inverse() const { return from_unit(quaternion().conjugate()); }
  template <class T>
  BasicSO3<detail::Promoted<S, T>, Chart> operator*(const BasicSO3<T, Chart>& b) const {
    return BasicSO3<detail::Promoted<S, T>, Chart>::from_unit(
        detail::renormalized(quaternion() * b.quaternion()));
  }
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 3> operator*(
      const Eigen::MatrixBase<Derived>& p) const {
    using P = typename Derived::Scalar;
    return detail::rotate(quaternion(), P(p[0]), P(p[1]), P(p[2]));
  }

  template <class T>
  BasicSO3<T, Chart> cast() const {
    return BasicSO3<T, Chart>::from_unit(quaternion().template cast<T>());
  }

 private:
  template <class T>
  friend struct Manifold;
  struct Unit {};
  BasicSO3(const Quaternion& q, Unit) : coefficients_{q.x, q.y, q.z, q.w} {}

  std::array<S, 4> coefficients_;
};

using SO3 = BasicSO3<double>;
using SO3RotationVector = BasicSO3<double, detail::RotationVectorChart>;

/// Prints "SO3(0, 0, 0, 1)": the name, and qx qy qz qw.
std::ostream& operator<<(std::ostream& out, const SO3& x);
std::ostream& operator<<(std::ostream& out, const SO3RotationVector& x);

/// R ⊞ δ = R · Exp(δ), with the Exp of the chart; S ⊟ R = Log(Rᵀ S).
template <class S, class Chart>
struct Manifold<BasicSO3<S, Chart>> {
  template <class T>
  using Rebind = BasicSO3<T, Chart>;
  static constexpr int kDim = 3;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const BasicSO3<S, Chart>& x, const D* delta) {
    const detail::Quaternion<D> step = Chart::exp(delta[0], delta[1], delta[2]);
    return Rebind<detail::Promoted<S, D>>::from_unit(x.quaternion() * step);
  }
  template <class D>
  static void ominus(const BasicSO3<S, Chart>& y, const BasicSO3<S, Chart>& x, D* delta) {
    const Vector<S, 3> log = Chart::log(x.quaternion().conjugate() * y.quaternion());
    for (int i = 0; i < 3; ++i) delta[i] = log[i];
  }
  template <class T>
  static Rebind<T> cast(const BasicSO3<S, Chart>& x) {
    return x.template cast<T>();
  }
  template <class T>
  static void lift(const BasicSO3<S, Chart>& x, const detail::Seed<T>& seed, Rebind<T>& y) {
    detail::lift_rotation<Chart>(x.quaternion(), seed, 0, y.coefficients_.data());
  }
};

}  // namespace boxplus
