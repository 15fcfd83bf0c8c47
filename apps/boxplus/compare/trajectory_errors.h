// SPDX-License-Identifier: BSD-3-Clause
// The errors of a trajectory: the absolute trajectory error (ATE) and the relative pose error (RPE) of Sturm
// et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012.
#pragma once

#include <cstddef>
#include <vector>

#include "compare/alignment.h"

namespace boxplus::app {

/// Statistics of a list of lengths or angles; all 0 if it is empty.
struct ErrorStatistics {
  std::size_t count = 0;
  double rmse = 0, mean = 0, median = 0, max = 0;
};
ErrorStatistics statistics(std::vector<double> errors);

/// The distances of the aligned positions from the true ones, in meters.
ErrorStatistics absolute_error(const std::vector<PosePair>& pairs, const Alignment& alignment);

/// The poses that the relative error compares. Two poses are `steps` pairs apart. If `distance` is above 0,
/// the second is instead the first pose that the truth reaches after this many meters.
struct RelativeSpan {
  int steps = 1;
  double distance = 0;
};

struct RelativeError {
  ErrorStatistics translation;  ///< meters
  ErrorStatistics rotation;     ///< radians, in [0, π]
};

/// E = (Q₁⁻¹ Q₂)⁻¹ (P₁⁻¹ P₂), with true poses Q and poses P of the result: its translation and angle. The
/// alignment matters only through its scale. O(n).
RelativeError relative_error(const std::vector<PosePair>& pairs, double scale, const RelativeSpan& span);

}  // namespace boxplus::app
