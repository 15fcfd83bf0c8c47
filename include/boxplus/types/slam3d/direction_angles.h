// SPDX-License-Identifier: BSD-3-Clause
// Directions in space by azimuth and elevation, relative to another direction.
//
// The azimuth α of a vector v is its angle about the z-axis, from the x-axis. Its elevation ε is its angle
// above the xy-plane. The frame F(n) = Rz(α) Ry(−ε) of a direction n turns the x-axis to n. Its columns are
//   n,   y = (−sin α, cos α, 0),   (−sin ε cos α, −sin ε sin α, cos ε).
// If n is vertical, its azimuth is not defined; 0 is used. Such a frame is differentiated without a turn
// about n, so that derivatives stay finite.
#pragma once

#include <cmath>

#include "boxplus/base/matrix.h"
#include "boxplus/manifold/scalar.h"

namespace boxplus::detail {

/// A unit vector counts as vertical if its squared horizontal part is less than this. Up to here, the azimuth
/// has less than six correct digits.
inline constexpr double kVertical = 1e-20;

/// F(n) for a unit vector n.
template <class S>
Matrix<S, 3, 3> direction_frame(const Vector<S, 3>& n) {
  using std::sqrt;
  Matrix<S, 3, 3> f;
  const S horizontal2 = n[0] * n[0] + n[1] * n[1];
  if (horizontal2 < S(kVertical)) {
    f << n[0], S(0), -n[2], n[1], S(1), S(0), n[2], -n[1] / n[2], n[0];
    return f;
  }
  const S horizontal = sqrt(horizontal2), c = n[0] / horizontal, s = n[1] / horizontal;
  f << n[0], -s, -n[2] * c, n[1], c, -n[2] * s, n[2], S(0), horizontal;
  return f;
}

/// Azimuth and elevation of `to` in the frame F(from). Both are unit vectors.
template <class S>
Vector<S, 2> angles_between(const Vector<S, 3>& from, const Vector<S, 3>& to) {
  using std::atan2;
  using std::sqrt;
  const Matrix<S, 3, 3> f = direction_frame(from);
  const auto along = [&](int axis) -> S {
    return f(0, axis) * to[0] + f(1, axis) * to[1] + f(2, axis) * to[2];
  };
  const S x = along(0), y = along(1), z = along(2);
  const S horizontal2 = x * x + y * y;
  if (horizontal2 < S(kVertical)) return {S(0), S(atan2(z, x))};
  return {S(atan2(y, x)), S(atan2(z, S(sqrt(horizontal2))))};
}

/// The direction with this azimuth and elevation in the frame F(from): the inverse of angles_between().
template <class S, class D>
Vector<Promoted<S, D>, 3> turned_direction(const Vector<S, 3>& from, const D& azimuth, const D& elevation) {
  using std::cos;
  using std::sin;
  const Matrix<S, 3, 3> f = direction_frame(from);
  const D c = cos(elevation), x = c * cos(azimuth), y = c * sin(azimuth), z = sin(elevation);
  const auto coordinate = [&](int i) -> Promoted<S, D> { return f(i, 0) * x + f(i, 1) * y + f(i, 2) * z; };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

}  // namespace boxplus::detail
