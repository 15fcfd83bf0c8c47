// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions in the plane: position (meters) and heading (radians).
#pragma once

#include <array>
#include <iosfwd>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/lift.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// A pose (x, y, θ) with θ in (−π, π]. A heading that is already in this range is not changed. T_world_body *
/// p_body = p_world. Tangent: (Δx, Δy, Δθ) in the body frame. The cosine and sine of θ are stored as well.
/// They are computed once per estimate, so products of poses and points need no trigonometric functions.
template <class S>
class BasicSE2 {
 public:
  using Scalar = S;
  static constexpr std::string_view kName = "SE2";

  /// The identity.
  BasicSE2() : coefficients_{S(0), S(0), S(0), S(1), S(0)} {}
  BasicSE2(const S& x, const S& y, const S& theta) : BasicSE2(x, y, theta, S(1), S(0)) {
    using std::cos;
    using std::sin;
    coefficients_[3] = cos(coefficients_[2]);
    coefficients_[4] = sin(coefficients_[2]);
  }
  template <class Derived>
  BasicSE2(const Eigen::MatrixBase<Derived>& translation, const S& theta)
      : BasicSE2(S(translation[0]), S(translation[1]), theta) {}

  /// The pose (x, y, θ): v2t in the g2o document, the inverse of t2v.
  template <class Derived>
  static BasicSE2 from_vector(const Eigen::MatrixBase<Derived>& v) {
    return {S(v[0]), S(v[1]), S(v[2])};
  }
  /// The exponential of (υ_x, υ_y, ω), in meters and radians: the pose after one unit of time of a body that
  /// moves with the constant velocity υ and the constant angular velocity ω, both in its own frame. This is
  /// not ⊞, whose translation does not turn with the body.
  template <class Derived>
  static BasicSE2 exp(const Eigen::MatrixBase<Derived>& tangent) {
    const auto [a, b] = arc(S(tangent[2]));
    return {a * tangent[0] - b * tangent[1], b * tangent[0] + a * tangent[1], S(tangent[2])};
  }

  const S& x() const { return coefficients_[0]; }
  const S& y() const { return coefficients_[1]; }
  const S& theta() const { return coefficients_[2]; }
  const S& cos_theta() const { return coefficients_[3]; }
  const S& sin_theta() const { return coefficients_[4]; }
  /// x y θ and its cosine and sine, contiguous.
  const S* data() const { return coefficients_.data(); }

  /// (x, y, θ): t2v in the g2o document.
  Vector<S, 3> vector() const { return {x(), y(), theta()}; }
  Vector<S, 2> translation() const { return {x(), y()}; }
  Matrix<S, 2, 2> rotation() const {
    const S &c = cos_theta(), &s = sin_theta();
    Matrix<S, 2, 2> r;
    r << c, -s, s, c;
    return r;
  }

  /// The inverse of exp(), with ω in (−π, π].
  Vector<S, 3> log() const {
    const auto [a, b] = arc(theta());
    const S f = 1.0 / (a * a + b * b);
    return {f * (a * x() + b * y()), f * (a * y() - b * x()), theta()};
  }

  BasicSE2 inverse() const {
    const S &c = cos_theta(), &s = sin_theta();
    return {-(c * x() + s * y()), s * x() - c * y(), -theta(), c, -s};
  }

  /// Composition.
  template <class T>
  BasicSE2<detail::Promoted<S, T>> operator*(const BasicSE2<T>& b) const {
    const S &c = cos_theta(), &s = sin_theta();
    return {x() + (c * b.x() - s * b.y()), y() + (s * b.x() + c * b.y()), theta() + b.theta(),
            c * b.cos_theta() - s * b.sin_theta(), s * b.cos_theta() + c * b.sin_theta()};
  }
  /// Transforms the point p from the body frame to the outer frame.
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 2> operator*(
      const Eigen::MatrixBase<Derived>& p) const {
    const S &c = cos_theta(), &s = sin_theta();
    return {x() + (c * p[0] - s * p[1]), y() + (s * p[0] + c * p[1])};
  }

  /// inverse() * b, computed with one rotation fewer.
  template <class T>
  BasicSE2<detail::Promoted<S, T>> inverse_times(const BasicSE2<T>& b) const {
    const S &c = cos_theta(), &s = sin_theta();
    const detail::Promoted<S, T> dx = b.x() - x(), dy = b.y() - y();
    return {c * dx + s * dy, c * dy - s * dx, b.theta() - theta(), c * b.cos_theta() + s * b.sin_theta(),
            c * b.sin_theta() - s * b.cos_theta()};
  }
  /// inverse() * p for a point p.
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 2> inverse_times(
      const Eigen::MatrixBase<Derived>& p) const {
    const S &c = cos_theta(), &s = sin_theta();
    const detail::Promoted<S, typename Derived::Scalar> dx = p[0] - x(), dy = p[1] - y();
    return {c * dx + s * dy, c * dy - s * dx};
  }

  template <class T>
  BasicSE2<T> cast() const {
    return {T(x()), T(y()), T(theta()), T(cos_theta()), T(sin_theta())};
  }

 private:
  template <class T>
  friend class BasicSE2;
  template <class T>
  friend struct Manifold;
  /// sin θ / θ and (1 − cos θ) / θ.
  static std::array<S, 2> arc(const S& theta) {
    using std::cos;
    using std::sin;
    const S t = theta * theta;
    if (t < S(detail::kSmallSquaredAngle))
      return {1.0 - t * (1.0 / 6.0 - t * (1.0 / 120.0 - t * (1.0 / 5040.0))),
              theta * (0.5 - t * (1.0 / 24.0 - t * (1.0 / 720.0 - t * (1.0 / 40320.0))))};
    return {sin(theta) / theta, (1.0 - cos(theta)) / theta};
  }
  /// For callers that know the cosine and sine of the heading.
  BasicSE2(const S& x, const S& y, const S& theta, const S& cos_theta, const S& sin_theta)
      : coefficients_{x, y, detail::normalize_angle(theta), cos_theta, sin_theta} {}

  std::array<S, 5> coefficients_;
};

using SE2 = BasicSE2<double>;

/// Prints "SE2(1, 2, 0.5)": the name, and x y θ.
std::ostream& operator<<(std::ostream& out, const SE2& x);

/// ⊞ is motion composition (the g2o document, eq. 36): t += R(θ) Δt, θ = wrap(θ + Δθ).
/// y ⊟ x = (R(θx)ᵀ (ty − tx), wrap(θy − θx)).
template <class S>
struct Manifold<BasicSE2<S>> {
  template <class T>
  using Rebind = BasicSE2<T>;
  static constexpr int kDim = 3;

  template <class D>
  static BasicSE2<detail::Promoted<S, D>> oplus(const BasicSE2<S>& x, const D* delta) {
    const S &c = x.cos_theta(), &s = x.sin_theta();
    return {x.x() + (c * delta[0] - s * delta[1]), x.y() + (s * delta[0] + c * delta[1]),
            x.theta() + delta[2]};
  }
  template <class D>
  static void ominus(const BasicSE2<S>& y, const BasicSE2<S>& x, D* delta) {
    const BasicSE2<S> difference = x.inverse_times(y);
    for (int i = 0; i < 3; ++i) delta[i] = difference.data()[i];
  }
  template <class T>
  static BasicSE2<T> cast(const BasicSE2<S>& x) {
    return x.template cast<T>();
  }
  template <class T>
  static void lift(const BasicSE2<S>& x, const detail::Seed<T>& seed, BasicSE2<T>& y) {
    const double c = x.cos_theta(), s = x.sin_theta();
    seed.set(y.coefficients_[0], x.x(), 0, {c, -s});
    seed.set(y.coefficients_[1], x.y(), 0, {s, c});
    seed.set(y.coefficients_[2], x.theta(), 2, {1.0});
    seed.set(y.coefficients_[3], c, 2, {-s});
    seed.set(y.coefficients_[4], s, 2, {c});
  }
};

}  // namespace boxplus
