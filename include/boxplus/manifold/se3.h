// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions in space: translation (meters) and unit quaternion.
#pragma once

#include <array>
#include <iosfwd>
#include <string_view>
#include <type_traits>

#include "boxplus/manifold/lift.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/sim3_exponential.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {

/// A pose, stored as x y z qx qy qz qw, which is also the order in g2o files. T_world_body * p_body =
/// p_world. Chart selects the tangent, which is in the body frame: (Δt, q_v) with QuaternionChart, (Δt, ω)
/// with RotationVectorChart. VERTEX_SE3:QUAT and the information of EDGE_SE3:QUAT use QuaternionChart.
template <class S, class Chart = detail::QuaternionChart>
class BasicSE3 {
 public:
  using Scalar = S;
  using Quaternion = detail::Quaternion<S>;
  static constexpr std::string_view kName =
      std::is_same_v<Chart, detail::RotationVectorChart> ? "SE3RotationVector" : "SE3";

  /// The identity.
  BasicSE3() : coefficients_{S(0), S(0), S(0), S(0), S(0), S(0), S(1)} {}
  /// Normalizes q unless it is a unit quaternion up to rounding.
  template <class Derived>
  BasicSE3(const Eigen::MatrixBase<Derived>& translation, const Quaternion& q)
      : BasicSE3(from_unit(translation, detail::normalized(q))) {}
  template <class Derived>
  BasicSE3(const Eigen::MatrixBase<Derived>& translation, const BasicSO3<S, Chart>& rotation)
      : BasicSE3(from_unit(translation, rotation.quaternion())) {}
  template <class Derived>
  BasicSE3(const Eigen::MatrixBase<Derived>& translation, const Matrix<S, 3, 3>& rotation)
      : BasicSE3(translation, detail::quaternion_of(rotation)) {}
  template <class Derived, class Q>
  BasicSE3(const Eigen::MatrixBase<Derived>& translation, const Eigen::QuaternionBase<Q>& q)
      : BasicSE3(translation, Quaternion{S(q.x()), S(q.y()), S(q.z()), S(q.w())}) {}

  /// q must be a unit quaternion.
  template <class Derived>
  static BasicSE3 from_unit(const Eigen::MatrixBase<Derived>& translation, const Quaternion& q) {
    BasicSE3 x;
    x.coefficients_ = {S(translation[0]), S(translation[1]), S(translation[2]), q.x, q.y, q.z, q.w};
    return x;
  }
  /// From x y z qx qy qz qw.
  template <class Derived>
  static BasicSE3 from_vector(const Eigen::MatrixBase<Derived>& v) {
    return BasicSE3(v.template head<3>(), Quaternion{S(v[3]), S(v[4]), S(v[5]), S(v[6])});
  }
  /// The exponential of (υ, ω), in meters and radians: the pose after one unit of time of a body that moves
  /// with the constant velocity υ and the constant angular velocity ω, both in its own frame. This is not ⊞,
  /// whose translation does not turn with the body. The translation is V υ (Barfoot, "State Estimation for
  /// Robotics", 2017, eq. 7.85).
  template <class Derived>
  static BasicSE3 exp(const Eigen::MatrixBase<Derived>& tangent) {
    const Vector<S, 6> v = tangent;
    const Vector<S, 3> omega = v.template tail<3>();
    const auto coupling = detail::Sim3Coupling<S>::of(S(0), omega.squaredNorm());
    return from_unit(coupling.apply(omega, v.template head<3>()),
                     detail::RotationVectorChart::exp(omega[0], omega[1], omega[2]));
  }
  /// The inverse of minimal().
  template <class Derived>
  static BasicSE3 from_minimal(const Eigen::MatrixBase<Derived>& v) {
    return from_unit(v.template head<3>(), detail::QuaternionChart::exp(S(v[3]), S(v[4]), S(v[5])));
  }

  Vector<S, 3> translation() const { return {coefficients_[0], coefficients_[1], coefficients_[2]}; }
  Quaternion quaternion() const {
    return {coefficients_[3], coefficients_[4], coefficients_[5], coefficients_[6]};
  }
  BasicSO3<S, Chart> so3() const { return BasicSO3<S, Chart>::from_unit(quaternion()); }
  Matrix<S, 3, 3> rotation() const { return detail::rotation_matrix(quaternion()); }
  /// x y z qx qy qz qw.
  Vector<S, 7> vector() const { return Eigen::Map<const Vector<S, 7>>(data()); }
  /// The error vector of EDGE_SE3:QUAT: [translation; vector part of the quaternion with w ≥ 0].
  Vector<S, 6> minimal() const {
    const Vector<S, 3> v = detail::QuaternionChart::log(quaternion());
    Vector<S, 6> e;
    e << coefficients_[0], coefficients_[1], coefficients_[2], v[0], v[1], v[2];
    return e;
  }
  /// The inverse of exp(), with |ω| ≤ π.
  Vector<S, 6> log() const {
    const Vector<S, 3> omega = detail::RotationVectorChart::log(quaternion());
    const S theta2 = omega.squaredNorm();
    Vector<S, 6> tangent;
    tangent << detail::Sim3Coupling<S>::of(S(0), theta2).inverse(theta2).apply(omega, translation()), omega;
    return tangent;
  }
  /// x y z qx qy qz qw, contiguous.
  const S* data() const { return coefficients_.data(); }

  BasicSE3 inverse() const {
    const Quaternion q = quaternion().conjugate();
    return from_unit(detail::rotate(q, S(-coefficients_[0]), S(-coefficients_[1]), S(-coefficients_[2])), q);
  }

  /// Composition.
  template <class T>
  BasicSE3<detail::Promoted<S, T>, Chart> operator*(const BasicSE3<T, Chart>& b) const {
    return BasicSE3<detail::Promoted<S, T>, Chart>::from_unit(
        *this * b.translation(), detail::renormalized(quaternion() * b.quaternion()));
  }
  /// Transforms the point p from the body frame to the outer frame.
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 3> operator*(
      const Eigen::MatrixBase<Derived>& p) const {
    using P = typename Derived::Scalar;
    const Vector<detail::Promoted<S, P>, 3> r = detail::rotate(quaternion(), P(p[0]), P(p[1]), P(p[2]));
    return {coefficients_[0] + r[0], coefficients_[1] + r[1], coefficients_[2] + r[2]};
  }

  /// inverse() * b, computed with one rotation fewer. Unlike operator*, it does not correct the norm of the
  /// quaternion. operator* corrects the norm only for double, and error functions must have the same value
  /// for double and for dual numbers.
  template <class T>
  BasicSE3<detail::Promoted<S, T>, Chart> inverse_times(const BasicSE3<T, Chart>& b) const {
    return BasicSE3<detail::Promoted<S, T>, Chart>::from_unit(inverse_times(b.translation()),
                                                              quaternion().conjugate() * b.quaternion());
  }
  /// inverse() * p for a point p.
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 3> inverse_times(
      const Eigen::MatrixBase<Derived>& p) const {
    using R = detail::Promoted<S, typename Derived::Scalar>;
    return detail::rotate(quaternion().conjugate(), R(p[0] - coefficients_[0]), R(p[1] - coefficients_[1]),
                          R(p[2] - coefficients_[2]));
  }

  template <class T>
  BasicSE3<T, Chart> cast() const {
    return BasicSE3<T, Chart>::from_unit(translation().template cast<T>(), quaternion().template cast<T>());
  }

 private:
  template <class T>
  friend struct Manifold;

  std::array<S, 7> coefficients_;
};

using SE3 = BasicSE3<double>;
using SE3RotationVector = BasicSE3<double, detail::RotationVectorChart>;

/// Prints "SE3(1, 2, 3, 0, 0, 0, 1)": the name, and x y z qx qy qz qw.
std::ostream& operator<<(std::ostream& out, const SE3& x);
std::ostream& operator<<(std::ostream& out, const SE3RotationVector& x);

/// Right perturbation: t += R Δt, R ← R · Exp(δ_R), with the Exp of the chart. Exp returns a unit quaternion,
/// and ⊞ does not normalize the product, so a step does not change the norm of the quaternion. This matters
/// for poses that were read from files by from_unit(). Their quaternions do not have exactly unit norm,
/// because the digits in the file are rounded. If the first step normalized them, chi2 would change. y ⊟ x =
/// (R_xᵀ (t_y − t_x), Log(R_xᵀ R_y)).
template <class S, class Chart>
struct Manifold<BasicSE3<S, Chart>> {
  template <class T>
  using Rebind = BasicSE3<T, Chart>;
  static constexpr int kDim = 6;

  template <class D>
  static Rebind<detail::Promoted<S, D>> oplus(const BasicSE3<S, Chart>& x, const D* delta) {
    const detail::Quaternion<D> step = Chart::exp(delta[3], delta[4], delta[5]);
    return Rebind<detail::Promoted<S, D>>::from_unit(x * Eigen::Map<const Vector<D, 3>>(delta),
                                                     x.quaternion() * step);
  }
  template <class D>
  static void ominus(const BasicSE3<S, Chart>& y, const BasicSE3<S, Chart>& x, D* delta) {
    const Vector<S, 3> translation = x.inverse_times(y.translation());
    const Vector<S, 3> rotation = Chart::log(x.quaternion().conjugate() * y.quaternion());
    for (int i = 0; i < 3; ++i) delta[i] = translation[i];
    for (int i = 0; i < 3; ++i) delta[3 + i] = rotation[i];
  }
  template <class T>
  static Rebind<T> cast(const BasicSE3<S, Chart>& x) {
    return x.template cast<T>();
  }
  template <class T>
  static void lift(const BasicSE3<S, Chart>& x, const detail::Seed<T>& seed, Rebind<T>& y) {
    const Matrix<double, 3, 3> R = x.rotation();
    for (int i = 0; i < 3; ++i)
      seed.set(y.coefficients_[static_cast<std::size_t>(i)], x.data()[i], 0, {R(i, 0), R(i, 1), R(i, 2)});
    detail::lift_rotation<Chart>(x.quaternion(), seed, 3, y.coefficients_.data() + 3);
  }
};

}  // namespace boxplus
