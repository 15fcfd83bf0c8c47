// SPDX-License-Identifier: BSD-3-Clause
// Unit quaternions (Hamilton convention), with coefficients in the order x y z w as in files.
#pragma once

#include <cmath>
#include <type_traits>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus::detail {

/// The quaternion x i + y j + z k + w. It describes a rotation if its norm is one.
template <class S>
struct Quaternion {
  S x, y, z, w;

  static Quaternion identity() { return {S(0), S(0), S(0), S(1)}; }
  Quaternion conjugate() const { return {-x, -y, -z, w}; }
  Quaternion operator-() const { return {-x, -y, -z, -w}; }
  S squared_norm() const { return x * x + y * y + z * z + w * w; }

  template <class T>
  Quaternion<T> cast() const {
    return {T(x), T(y), T(z), T(w)};
  }
};

/// The Hamilton product: rotate by b, then by a.
template <class A, class B>
Quaternion<Promoted<A, B>> operator*(const Quaternion<A>& a, const Quaternion<B>& b) {
  return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
          a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}

template <class S>
Quaternion<S> scaled(const Quaternion<S>& q, const S& factor) {
  return {q.x * factor, q.y * factor, q.z * factor, q.w * factor};
}

/// If the squared norm differs from one by less than this, the difference counts as rounding error, and the
/// coefficients are not changed. So a unit quaternion from a file keeps its digits, and a zero step changes
/// nothing.
inline constexpr double kUnitNormTolerance = 1e-15;

/// q, scaled to unit norm. The zero quaternion becomes the identity.
template <class S>
Quaternion<S> normalized(const Quaternion<S>& q) {
  using std::sqrt;
  const S n2 = q.squared_norm();
  if (n2 > S(1 - kUnitNormTolerance) && n2 < S(1 + kUnitNormTolerance)) return q;
  if (n2 == S(0)) return Quaternion<S>::identity();
  return scaled(q, S(S(1) / sqrt(n2)));
}

/// The factor that scales a vector of squared norm n2 ≈ 1 back to unit norm after one product: one Newton
/// step toward 1/√n2, or exactly 1 if n2 differs from 1 only by rounding.
inline double renormalizing_factor(double n2) {
  return std::abs(n2 - 1) < kUnitNormTolerance ? 1.0 : 1.5 - 0.5 * n2;
}

/// Removes the rounding error of one product from the norm of a unit quaternion. Returns quaternions of dual
/// numbers unchanged, because at unit norm this correction does not change derivatives along the sphere.
template <class S>
Quaternion<S> renormalized(const Quaternion<S>& q) {
  if constexpr (std::is_floating_point_v<S>) {
    return scaled(q, renormalizing_factor(q.squared_norm()));
  } else {
    return q;
  }
}

/// R(q) p = p + 2w (v × p) + 2 v × (v × p).
template <class S, class P>
Vector<Promoted<S, P>, 3> rotate(const Quaternion<S>& q, const P& px, const P& py, const P& pz) {
  using R = Promoted<S, P>;
  const R tx = 2.0 * (q.y * pz - q.z * py);
  const R ty = 2.0 * (q.z * px - q.x * pz);
  const R tz = 2.0 * (q.x * py - q.y * px);
  return {px + q.w * tx + (q.y * tz - q.z * ty), py + q.w * ty + (q.z * tx - q.x * tz),
          pz + q.w * tz + (q.x * ty - q.y * tx)};
}

template <class S>
Matrix<S, 3, 3> rotation_matrix(const Quaternion<S>& q) {
  const S xx = 2.0 * q.x * q.x, yy = 2.0 * q.y * q.y, zz = 2.0 * q.z * q.z;
  const S xy = 2.0 * q.x * q.y, xz = 2.0 * q.x * q.z, yz = 2.0 * q.y * q.z;
  const S wx = 2.0 * q.w * q.x, wy = 2.0 * q.w * q.y, wz = 2.0 * q.w * q.z;
  Matrix<S, 3, 3> r;
  r << 1.0 - (yy + zz), xy - wz, xz + wy, xy + wz, 1.0 - (xx + zz), yz - wx, xz - wy, yz + wx,
      1.0 - (xx + yy);
  return r;
}

/// The unit quaternion of a rotation matrix. Divides only by a coefficient of at least ½ (Shepperd 1978).
template <class Derived>
Quaternion<typename Derived::Scalar> quaternion_of(const Eigen::MatrixBase<Derived>& r) {
  using S = typename Derived::Scalar;
  using std::sqrt;
  const S trace = r(0, 0) + r(1, 1) + r(2, 2);
  if (trace > S(0)) {
    const S w = 0.5 * sqrt(S(trace + 1.0));
    const S f = 0.25 / w;
    return {(r(2, 1) - r(1, 2)) * f, (r(0, 2) - r(2, 0)) * f, (r(1, 0) - r(0, 1)) * f, w};
  }
  const int i = r(1, 1) > r(0, 0) ? (r(2, 2) > r(1, 1) ? 2 : 1) : (r(2, 2) > r(0, 0) ? 2 : 0);
  const int j = (i + 1) % 3, k = (i + 2) % 3;
  S v[3];
  v[i] = 0.5 * sqrt(S(r(i, i) - r(j, j) - r(k, k) + 1.0));
  const S f = 0.25 / v[i];
  v[j] = (r(j, i) + r(i, j)) * f;
  v[k] = (r(k, i) + r(i, k)) * f;
  return {v[0], v[1], v[2], (r(k, j) - r(j, k)) * f};
}

}  // namespace boxplus::detail
