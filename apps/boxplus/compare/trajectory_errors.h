// SPDX-License-Identifier: BSD-3-Clause
// How far a trajectory is from its truth: the absolute trajectory error (ATE) and the relative pose error
// (RPE) of Sturm et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012.
#pragma once

#include <cstddef>
#include <vector>

#include "compare/alignment.h"

namespace boxplus::app {

/// Of a list of lengths or angles; all 0 if it is empty.
struct ErrorStatistics {
  std::size_t count = 0;
  double rmse = 0, mean = 0, median = 0, max = 0;
};
ErrorStatistics statistics(std::vector<double> errors);

/// The distances of the aligned positions from the true ones, in metres.
ErrorStatistics absolute_error(const std::vector<PosePair>& pairs, const Alignment& alignment);

/// Which poses the relative error compares: those `steps` pairs apart or, if `distance` is above 0, each with
/// the first that the truth reaches after so many metres.
struct RelativeSpan {
  int steps = 1;
  double distance = 0;
};

struct RelativeError {
  ErrorStatistics translation;  ///< metres
  ErrorStatistics rotation;     ///< radians, in [0, π]
};

/// E = (Q₁⁻¹ Q₂)⁻¹ (P₁⁻¹ P₂) for the true poses Q and those of the result P: its translation and angle. Does
/// not depend on the alignment but for its scale. O(n).
RelativeError relative_error(const std::vector<PosePair>& pairs, double scale, const RelativeSpan& span);

}  // namespace boxplus::app
