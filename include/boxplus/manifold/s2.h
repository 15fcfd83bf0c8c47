// SPDX-License-Identifier: BSD-3-Clause
// Directions in space: points of the unit sphere, with a two-dimensional tangent.
#pragma once

#include <array>
#include <cmath>
#include <iosfwd>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/quaternion.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// A unit vector.
template <class S>
class BasicS2 {
 public:
  using Scalar = S;
  static constexpr std::string_view kName = "S2";

  /// The direction of the z axis.
  BasicS2() : coefficients_{S(0), S(0), S(1)} {}
  /// The direction of v, which must not be zero. If v is already a unit vector up to rounding, its
  /// coordinates are not changed.
  template <class Derived>
  explicit BasicS2(const Eigen::MatrixBase<Derived>& v) : coefficients_{S(v[0]), S(v[1]), S(v[2])} {
    using std::sqrt;
    const S n2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (n2 > S(1 - detail::kUnitNormTolerance) && n2 < S(1 + detail::kUnitNormTolerance)) return;
    const S f = S(1) / sqrt(n2);
    for (S& c : coefficients_) c = c * f;
  }

  /// (x, y, z) must be a unit vector.
  static BasicS2 from_unit(const S& x, const S& y, const S& z) {
    BasicS2 d;
    d.coefficients_ = {x, y, z};
    return d;
  }

  Vector<S, 3> vector() const { return {coefficients_[0], coefficients_[1], coefficients_[2]}; }
  const S* data() const { return coefficients_.data(); }

  /// An orthonormal basis of the tangent plane: the images of e_x and e_y (up to sign) under the Householder
  /// reflection that maps ∓e_z to the direction. The sign of e_z is chosen so that no digits cancel (cf. Duff
  /// et al., "Building an orthonormal basis, revisited", JCGT 2017). The basis is a smooth function of the
  /// direction except at z = 0.
  Matrix<S, 3, 2> tangent_basis() const {
    const S &x = coefficients_[0], &y = coefficients_[1], &z = coefficients_[2];
    const double sign = z < S(0) ? -1 : 1;
    const S f = 1.0 / (sign + z);
    const S xy = x * y * f;
    Matrix<S, 3, 2> basis;
    basis << 1.0 - sign * (x * x * f), -xy, -sign * xy, sign - y * y * f, -sign * x, -y;
    return basis;
  }

  template <class T>
  BasicS2<T> cast() const {
    return BasicS2<T>::from_unit(T(coefficients_[0]), T(coefficients_[1]), T(coefficients_[2]));
  }

 private:
  std::array<S, 3> coefficients_;
};

using S2 = BasicS2<double>;

/// Prints "S2(0, 0, 1)": the name and the unit vector.
std::ostream& operator<<(std::ostream& out, const S2& x);

/// ⊞ moves |δ| radians along the great circle that leaves x in direction B δ (B = tangent_basis). ⊟ is its
/// inverse; for opposite directions, it returns one of the shortest paths.
template <class S>
struct Manifold<BasicS2<S>> {
  template <class T>
  using Rebind = BasicS2<T>;
  static constexpr int kDim = 2;

  template <class D>
  static BasicS2<detail::Promoted<S, D>> oplus(const BasicS2<S>& d, const D* delta) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const D t = delta[0] * delta[0] + delta[1] * delta[1];
    D c, sinc;
    if (t < D(detail::kSmallSquaredAngle)) {
      c = 1.0 - t * (1.0 / 2.0 - t * (1.0 / 24.0 - t * (1.0 / 720.0 - t * (1.0 / 40320.0))));
      sinc = 1.0 - t * (1.0 / 6.0 - t * (1.0 / 120.0 - t * (1.0 / 5040.0)));
    } else {
      const D angle = sqrt(t);
      c = cos(angle);
      sinc = sin(angle) / angle;
    }
    const Matrix<S, 3, 2> basis = d.tangent_basis();
    const D u = sinc * delta[0], v = sinc * delta[1];
    const auto coordinate = [&](int i) -> detail::Promoted<S, D> {
      return c * d.data()[i] + (basis(i, 0) * u + basis(i, 1) * v);
    };
    return without_drift(
        BasicS2<detail::Promoted<S, D>>::from_unit(coordinate(0), coordinate(1), coordinate(2)));
  }

  template <class D>
  static void ominus(const BasicS2<S>& y, const BasicS2<S>& x, D* delta) {
    using std::atan2;
    using std::sqrt;
    const Matrix<S, 3, 2> basis = x.tangent_basis();
    const S *p = y.data(), *q = x.data();
    const S u = basis(0, 0) * p[0] + basis(1, 0) * p[1] + basis(2, 0) * p[2];
    const S v = basis(0, 1) * p[0] + basis(1, 1) * p[1] + basis(2, 1) * p[2];
    const S c = q[0] * p[0] + q[1] * p[1] + q[2] * p[2];
    const S n2 = u * u + v * v;
    if (c > S(0) && n2 < S(detail::kSmallSquaredAngle)) {  // atan(n/c)/n
      const S t = n2 / (c * c);
      const S f = (1.0 - t * (1.0 / 3.0 - t * (1.0 / 5.0 - t * (1.0 / 7.0 - t * (1.0 / 9.0))))) / c;
      delta[0] = u * f;
      delta[1] = v * f;
    } else if (n2 == S(0)) {  // the opposite direction
      delta[0] = D(kPi);
      delta[1] = D(0);
    } else {
      const S n = sqrt(n2);
      const S f = atan2(n, c) / n;
      delta[0] = u * f;
      delta[1] = v * f;
    }
  }

  template <class T>
  static BasicS2<T> cast(const BasicS2<S>& x) {
    return x.template cast<T>();
  }

 private:
  /// One Newton step toward unit norm. Does not change dual numbers (see renormalized() in quaternion.h).
  template <class R>
  static BasicS2<R> without_drift(const BasicS2<R>& d) {
    if constexpr (std::is_floating_point_v<R>) {
      const R* v = d.data();
      const R f = detail::renormalizing_factor(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
      return BasicS2<R>::from_unit(v[0] * f, v[1] * f, v[2] * f);
    } else {
      return d;
    }
  }
};

}  // namespace boxplus
