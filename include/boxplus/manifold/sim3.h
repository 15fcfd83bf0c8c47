// SPDX-License-Identifier: BSD-3-Clause
// Similarities in space: rotation, translation and scale.
#pragma once

#include <array>
#include <iosfwd>
#include <string_view>

#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/rotation_charts.h"
#include "boxplus/manifold/sim3_exponential.h"

namespace boxplus {

/// x ↦ s R x + t with s > 0. The order of the tangent and of the logarithm is (ω, υ, σ): rotation vector,
/// translation, log scale.
template <class S>
class BasicSim3 {
 public:
  using Scalar = S;
  using Quaternion = detail::Quaternion<S>;
  static constexpr std::string_view kName = "Sim3";

  /// The identity.
  BasicSim3() : coefficients_{S(0), S(0), S(0), S(0), S(0), S(0), S(1), S(1)} {}
  /// Normalizes q unless it is a unit quaternion up to rounding.
  template <class Derived>
  BasicSim3(const Quaternion& q, const Eigen::MatrixBase<Derived>& translation, const S& scale)
      : BasicSim3(from_unit(detail::normalized(q), translation, scale)) {}

  /// q must be a unit quaternion.
  template <class Derived>
  static BasicSim3 from_unit(const Quaternion& q, const Eigen::MatrixBase<Derived>& t, const S& scale) {
    BasicSim3 x;
    x.coefficients_ = {S(t[0]), S(t[1]), S(t[2]), q.x, q.y, q.z, q.w, scale};
    return x;
  }

  Vector<S, 3> translation() const { return {coefficients_[0], coefficients_[1], coefficients_[2]}; }
  Quaternion quaternion() const {
    return {coefficients_[3], coefficients_[4], coefficients_[5], coefficients_[6]};
  }
  Matrix<S, 3, 3> rotation() const { return detail::rotation_matrix(quaternion()); }
  const S& scale() const { return coefficients_[7]; }
  /// x y z qx qy qz qw s, contiguous.
  const S* data() const { return coefficients_.data(); }

  /// The exponential of (ω, υ, σ).
  template <class Derived>
  static BasicSim3 exp(const Eigen::MatrixBase<Derived>& tangent) {
    using std::exp;
    const Vector<S, 7> v = tangent;
    const Vector<S, 3> omega = v.template head<3>(), upsilon = v.template segment<3>(3);
    const S sigma = v[6];
    const detail::Sim3Coupling<S> w = detail::Sim3Coupling<S>::of(sigma, omega.squaredNorm());
    return from_unit(detail::RotationVectorChart::exp(omega[0], omega[1], omega[2]), w.apply(omega, upsilon),
                     S(exp(sigma)));
  }
  /// The inverse of exp, with |ω| ≤ π.
  Vector<S, 7> log() const {
    using std::log;
    const Vector<S, 3> omega = detail::RotationVectorChart::log(quaternion());
    const S sigma = log(scale());
    const S theta2 = omega.squaredNorm();
    const Vector<S, 3> upsilon =
        detail::Sim3Coupling<S>::of(sigma, theta2).inverse(theta2).apply(omega, translation());
    Vector<S, 7> tangent;
    tangent << omega[0], omega[1], omega[2], upsilon[0], upsilon[1], upsilon[2], sigma;
    return tangent;
  }

  BasicSim3 inverse() const {
    const Quaternion q = quaternion().conjugate();
    const S scale_inverse = S(1) / scale();
    const S f = -scale_inverse;
    return from_unit(
        q, detail::rotate(q, S(f * coefficients_[0]), S(f * coefficients_[1]), S(f * coefficients_[2])),
        scale_inverse);
  }
  template <class T>
  BasicSim3<detail::Promoted<S, T>> operator*(const BasicSim3<T>& b) const {
    return BasicSim3<detail::Promoted<S, T>>::from_unit(detail::renormalized(quaternion() * b.quaternion()),
                                                        *this * b.translation(), scale() * b.scale());
  }
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 3> operator*(
      const Eigen::MatrixBase<Derived>& p) const {
    using P = typename Derived::Scalar;
    const Vector<detail::Promoted<S, P>, 3> r = detail::rotate(quaternion(), P(p[0]), P(p[1]), P(p[2]));
    return {scale() * r[0] + coefficients_[0], scale() * r[1] + coefficients_[1],
            scale() * r[2] + coefficients_[2]};
  }

  template <class T>
  BasicSim3<T> cast() const {
    return BasicSim3<T>::from_unit(quaternion().template cast<T>(), translation().template cast<T>(),
                                   T(scale()));
  }

 private:
  std::array<S, 8> coefficients_;
};

using Sim3 = BasicSim3<double>;

/// Prints "Sim3(1, 2, 3, 0, 0, 0, 1, 2)": the name, and x y z qx qy qz qw s.
std::ostream& operator<<(std::ostream& out, const Sim3& x);

/// x ⊞ δ = x · Exp(δ); y ⊟ x = Log(x⁻¹ y).
template <class S>
struct Manifold<BasicSim3<S>> {
  template <class T>
  using Rebind = BasicSim3<T>;
  static constexpr int kDim = 7;

  template <class D>
  static BasicSim3<detail::Promoted<S, D>> oplus(const BasicSim3<S>& x, const D* delta) {
    return x * BasicSim3<D>::exp(Eigen::Map<const Vector<D, 7>>(delta));
  }
  template <class D>
  static void ominus(const BasicSim3<S>& y, const BasicSim3<S>& x, D* delta) {
    const Vector<S, 7> log = (x.inverse() * y).log();
    for (int i = 0; i < 7; ++i) delta[i] = log[i];
  }
  template <class T>
  static BasicSim3<T> cast(const BasicSim3<S>& x) {
    return x.template cast<T>();
  }
};

}  // namespace boxplus
