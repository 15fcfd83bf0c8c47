// SPDX-License-Identifier: BSD-3-Clause
// Rotations in the plane.
#pragma once

#include <iosfwd>
#include <string_view>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/manifold.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus {

/// A rotation by an angle (radians) in (−π, π]. An angle that is already in this range is not changed.
/// Tangent: Δθ.
template <class S>
class BasicSO2 {
 public:
  using Scalar = S;
  static constexpr std::string_view kName = "SO2";

  /// The identity.
  BasicSO2() : angle_(0) {}
  explicit BasicSO2(const S& angle) : angle_(detail::normalize_angle(angle)) {}

  const S& angle() const { return angle_; }
  const S* data() const { return &angle_; }
  Matrix<S, 2, 2> rotation() const {
    using std::cos;
    using std::sin;
    const S c = cos(angle_), s = sin(angle_);
    Matrix<S, 2, 2> r;
    r << c, -s, s, c;
    return r;
  }

  BasicSO2 inverse() const { return BasicSO2(-angle_); }
  template <class T>
  BasicSO2<detail::Promoted<S, T>> operator*(const BasicSO2<T>& b) const {
    return BasicSO2<detail::Promoted<S, T>>(angle_ + b.angle());
  }
  template <class Derived>
  Vector<detail::Promoted<S, typename Derived::Scalar>, 2> operator*(
      const Eigen::MatrixBase<Derived>& p) const {
    using std::cos;
    using std::sin;
    const S c = cos(angle_), s = sin(angle_);
    return {c * p[0] - s * p[1], s * p[0] + c * p[1]};
  }

  template <class T>
  BasicSO2<T> cast() const {
    return BasicSO2<T>(T(angle_));
  }

 private:
  S angle_;
};

using SO2 = BasicSO2<double>;

/// Prints "SO2(0.5)": the name and the angle.
std::ostream& operator<<(std::ostream& out, const SO2& x);

template <class S>
struct Manifold<BasicSO2<S>> {
  template <class T>
  using Rebind = BasicSO2<T>;
  static constexpr int kDim = 1;

  template <class D>
  static BasicSO2<detail::Promoted<S, D>> oplus(const BasicSO2<S>& x, const D* delta) {
    return BasicSO2<detail::Promoted<S, D>>(x.angle() + delta[0]);
  }
  template <class D>
  static void ominus(const BasicSO2<S>& y, const BasicSO2<S>& x, D* delta) {
    delta[0] = detail::normalize_angle(S(y.angle() - x.angle()));
  }
  template <class T>
  static BasicSO2<T> cast(const BasicSO2<S>& x) {
    return x.template cast<T>();
  }
};

}  // namespace boxplus
