// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions of the plane: position (metres) and heading (radians).
#pragma once

#include <array>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// A pose (x, y, θ) with θ in (−π, π]. A heading in that range is kept bit for bit.
/// T_world_body * p_body = p_world. Tangent: (Δx, Δy, Δθ) in the body frame.
template <class S>
class BasicSE2 {
 public:
  using Scalar = S;
  static constexpr std::string_view kName = "SE2";

  /// The identity.
  BasicSE2() : coefficients_{S(0), S(0), S(0)} {}
  BasicSE2(const S& x, const S& y, const S& theta) : coefficients_{x, y, normalize_angle(theta)} {}
  template <class Derived>
  BasicSE2(const Eigen::MatrixBase<Derived>& translation, const S& theta)
      : BasicSE2(S(translation[0]), S(translation[1]), theta) {}

  /// The pose of (x, y, θ): t2v's inverse, v2t in the document.
  template <class Derived>
  static BasicSE2 from_vector(const Eigen::MatrixBase<Derived>& v) {
    return {S(v[0]), S(v[1]), S(v[2])};
  }

  const S& x() const { return coefficients_[0]; }
  const S& y() const { return coefficients_[1]; }
  const S& theta() const { return coefficients_[2]; }
  /// x y θ, contiguous.
  const S* data() const { return coefficients_.data(); }

  /// (x, y, θ): t2v in the document.
  Vector<S, 3> vector() const { return {x(), y(), theta()}; }
  Vector<S, 2> translation() const { return {x(), y()}; }
  Matrix<S, 2, 2> rotation() const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    Matrix<S, 2, 2> r;
    r << c, -s, s, c;
    return r;
  }

  BasicSE2 inverse() const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    return {-(c * x() + s * y()), s * x() - c * y(), -theta()};
  }

  /// Composition.
  template <class T>
  BasicSE2<Promoted<S, T>> operator*(const BasicSE2<T>& b) const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    return {x() + (c * b.x() - s * b.y()), y() + (s * b.x() + c * b.y()), theta() + b.theta()};
  }
  /// The point p of the body frame, in the frame of the pose.
  template <class Derived>
  Vector<Promoted<S, typename Derived::Scalar>, 2> operator*(const Eigen::MatrixBase<Derived>& p) const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    return {x() + (c * p[0] - s * p[1]), y() + (s * p[0] + c * p[1])};
  }

  /// inverse() * b with one rotation less.
  template <class T>
  BasicSE2<Promoted<S, T>> inverse_times(const BasicSE2<T>& b) const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    const Promoted<S, T> dx = b.x() - x(), dy = b.y() - y();
    return {c * dx + s * dy, c * dy - s * dx, b.theta() - theta()};
  }
  /// inverse() * p for a point p.
  template <class Derived>
  Vector<Promoted<S, typename Derived::Scalar>, 2> inverse_times(const Eigen::MatrixBase<Derived>& p) const {
    using std::cos;
    using std::sin;
    const S c = cos(theta()), s = sin(theta());
    const Promoted<S, typename Derived::Scalar> dx = p[0] - x(), dy = p[1] - y();
    return {c * dx + s * dy, c * dy - s * dx};
  }

  template <class T>
  BasicSE2<T> cast() const {
    return {T(x()), T(y()), T(theta())};
  }

 private:
  std::array<S, 3> coefficients_;
};

using SE2 = BasicSE2<double>;

/// ⊞ is motion composition (the g2o document, eq. 36): t += R(θ) Δt, θ = wrap(θ + Δθ).
/// y ⊟ x = (R(θx)ᵀ (ty − tx), wrap(θy − θx)).
template <class S>
struct Manifold<BasicSE2<S>> {
  template <class T>
  using Rebind = BasicSE2<T>;
  static constexpr int kDim = 3;

  template <class D>
  static BasicSE2<Promoted<S, D>> oplus(const BasicSE2<S>& x, const D* delta) {
    using std::cos;
    using std::sin;
    const S c = cos(x.theta()), s = sin(x.theta());
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
};

}  // namespace boxplus
