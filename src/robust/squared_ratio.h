// SPDX-License-Identifier: BSD-3-Clause
// The ratio of a squared error and the square of a width.
#pragma once

#include <cmath>

namespace boxplus {

/// e2 / d2. If e2 is finite, the ratio is at most 1e290, so that 1 plus the ratio, and smaller powers
/// of it, do not overflow.
inline double squared_ratio(double e2, double d2) {
  constexpr double kMost = 1e290;
  const double ratio = e2 / d2;
  return ratio > kMost && std::isfinite(e2) ? kMost : ratio;
}

}  // namespace boxplus
