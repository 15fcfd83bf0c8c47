// SPDX-License-Identifier: BSD-3-Clause
// Two charts of rotations in space: how three scalars become a unit quaternion, and back.
//
// Dual numbers differentiate both charts exactly, also at 0. The units of the charts differ by a factor of
// two, because the quaternion chart measures about half the angle per axis. So the same information matrix Ω
// has a different meaning in each chart.
#pragma once

#include <cmath>

#include "boxplus/manifold/quaternion.h"

namespace boxplus::detail {

/// δ is the vector part of the quaternion: q = (δ, √(1 − |δ|²)). If |δ| ≥ 1, q = (δ/|δ|, 0). The chart covers
/// every rotation once, with w ≥ 0. VERTEX_SE3:QUAT uses this chart.
struct QuaternionChart {
  static constexpr double kSlope = 1;  ///< of the vector part of exp(δ) at δ = 0
  template <class S>
  static Quaternion<S> exp(const S& x, const S& y, const S& z) {
    using std::sqrt;
    const S n2 = x * x + y * y + z * z;
    if (n2 < S(1)) return {x, y, z, S(sqrt(S(1.0 - n2)))};
    const S f = 1.0 / sqrt(n2);
    return {x * f, y * f, z * f, S(0)};
  }
  template <class S>
  static Vector<S, 3> log(const Quaternion<S>& q) {
    if (q.w < S(0)) return {-q.x, -q.y, -q.z};
    return {q.x, q.y, q.z};
  }
};

/// δ is the rotation vector: axis times angle (radians). q = (δ sin(|δ|/2)/|δ|, cos(|δ|/2)).
/// log() returns the vector of length ≤ π.
struct RotationVectorChart {
  static constexpr double kSlope = 0.5;  ///< of the vector part of exp(δ) at δ = 0
  template <class S>
  static Quaternion<S> exp(const S& x, const S& y, const S& z) {
    using std::cos;
    using std::sin;
    using std::sqrt;
    const S t = x * x + y * y + z * z;
    if (t < S(kSmallSquaredAngle)) {
      const S f = 0.5 - t * (1.0 / 48.0 - t * (1.0 / 3840.0 - t * (1.0 / 645120.0)));
      return {x * f, y * f, z * f, S(1.0 - t * (1.0 / 8.0 - t * (1.0 / 384.0 - t * (1.0 / 46080.0))))};
    }
    const S angle = sqrt(t), half = 0.5 * angle;
    const S f = sin(half) / angle;
    return {x * f, y * f, z * f, S(cos(half))};
  }
  template <class S>
  static Vector<S, 3> log(const Quaternion<S>& q) {
    using std::atan2;
    using std::sqrt;
    if (q.w < S(0)) return log(-q);
    const S n2 = q.x * q.x + q.y * q.y + q.z * q.z;
    if (n2 < S(kSmallSquaredAngle)) {  // 2 atan(n/w)/n
      const S t = n2 / (q.w * q.w);
      const S f = (2.0 - t * (2.0 / 3.0 - t * (2.0 / 5.0 - t * (2.0 / 7.0 - t * (2.0 / 9.0))))) / q.w;
      return {q.x * f, q.y * f, q.z * f};
    }
    const S n = sqrt(n2);
    const S f = 2.0 * atan2(n, q.w) / n;
    return {q.x * f, q.y * f, q.z * f};
  }
};

/// y ← q · exp(δ) at δ = 0 over dual numbers, as x y z w, if δ[0] is entry k of the seed (manifold/lift.h).
template <class Chart, class S, class Seed>
void lift_rotation(const Quaternion<double>& q, const Seed& seed, int k, S* y) {
  const Quaternion<double> h = scaled(q, Chart::kSlope);
  seed.set(y[0], q.x, k, {h.w, -h.z, h.y});
  seed.set(y[1], q.y, k, {h.z, h.w, -h.x});
  seed.set(y[2], q.z, k, {-h.y, h.x, h.w});
  seed.set(y[3], q.w, k, {-h.x, -h.y, -h.z});
}

}  // namespace boxplus::detail
