// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/types/sim3/sim3.h"

namespace g2o {
namespace adapters {

/// Whether a similarity, its inverse and their logarithms are finite. They may overflow if the scale is below
/// 1e-100 or above 1e100.
inline bool is_usable(const Sim3& x) {
  constexpr double kSmallest = 1e-100, kLargest = 1e100;
  if (!x.rotation().coeffs().allFinite() || !x.translation().allFinite()) return false;
  const double s = x.scale(), farthest = x.translation().cwiseAbs().maxCoeff();
  return s > kSmallest && s < kLargest && farthest < kLargest && farthest < kLargest * s;
}

inline constexpr const char* kExpectedUsableSim3 =
    "expected a similarity with a scale between 1e-100 and 1e100 and a finite translation";

}  // namespace adapters
}  // namespace g2o
