// SPDX-License-Identifier: BSD-3-Clause
// The errors of a trajectory: the absolute trajectory error (ATE) and the relative pose error (RPE) of Sturm
// et al., A benchmark for the evaluation of RGB-D SLAM systems, IROS 2012.
#pragma once

#include <cstddef>
#include <vector>

#include "trajectory/alignment.h"

namespace boxplus {

/// Statistics of a list of lengths or angles. If the list is empty, all of them are 0. O(n).
struct ErrorStatistics {
  std::size_t count = 0;
  double rmse = 0, mean = 0, median = 0, max = 0;
};
ErrorStatistics error_statistics(std::vector<double> errors);

/// Returns the statistics of the distances, in meters, between the aligned positions and the true positions.
ErrorStatistics absolute_error(const std::vector<PosePair>& pairs, const Alignment& alignment);

/// Selects the poses between which the relative error is computed. If `distance` is 0, the second pose is
/// `steps` pairs after the first pose. If `distance` is above 0, the second pose is the first pose whose
/// distance from the first pose along the true path is at least `distance` meters.
struct RelativeSpan {
  int steps = 1;
  double distance = 0;
};

struct RelativeError {
  ErrorStatistics translation;  ///< lengths in meters
  ErrorStatistics rotation;     ///< angles in radians, from 0 to π
};

/// Returns the statistics of the translation and the angle of E = (Q₁⁻¹ Q₂)⁻¹ (P₁⁻¹ P₂). The poses Q are from
/// the truth and the poses P are from the result. `scale` is the scale of the alignment; its rotation and
/// translation have no effect. Takes O(n) time.
RelativeError relative_error(const std::vector<PosePair>& pairs, double scale, const RelativeSpan& span);

}  // namespace boxplus
