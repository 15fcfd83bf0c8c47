// SPDX-License-Identifier: BSD-3-Clause
// Norms and products of steps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "base/all_finite.h"

namespace boxplus {

inline double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

inline double max_abs(std::span<const double> a) {
  double largest = 0;
  for (double v : a) largest = std::max(largest, std::abs(v));
  return largest;
}

/// The decrease of chi2 that the quadratic model predicts for the step δ: −(2 gᵀδ + δᵀHδ). `curvature` is
/// δᵀHδ.
inline double model_decrease(std::span<const double> gradient, std::span<const double> step,
                             double curvature) {
  return -(2 * dot(gradient, step) + curvature);
}

/// A decrease below this fraction of chi2 is only a rounding error.
inline constexpr double kRounding = 1e-12;

}  // namespace boxplus
