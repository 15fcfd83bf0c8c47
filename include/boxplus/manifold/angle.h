// SPDX-License-Identifier: BSD-3-Clause
// Angles in radians, wrapped to (−π, π].
#pragma once

#include <cmath>
#include <numbers>
#include <type_traits>

namespace boxplus {

inline constexpr double kPi = std::numbers::pi;

}  // namespace boxplus

namespace boxplus::detail {

/// The angle in (−π, π] that differs from x by a multiple of 2π. If x is already in that range, returns x
/// unchanged. For dual numbers, the derivative is 1.
template <class S>
S normalize_angle(const S& x) {
  if constexpr (std::is_floating_point_v<S>) {
    if (x > -kPi && x <= kPi) return x;
    const S wrapped = std::remainder(x, S(2 * kPi));
    return wrapped <= -kPi ? wrapped + S(2 * kPi) : wrapped;
  } else {
    S wrapped = x;
    wrapped.value = normalize_angle(x.value);
    return wrapped;
  }
}

}  // namespace boxplus::detail
