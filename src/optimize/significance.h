// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "boxplus/options/options.h"

namespace boxplus {

/// Decides whether further decreases of chi2 are insignificant compared with the noise of the measurements.
///
/// If Ω is right, a decrease of chi2 by 1 corresponds to estimates that move by one standard deviation in one
/// direction. If Ω is right only up to an unknown factor, the same movement decreases chi2 by the estimated
/// variance s² = chi2 / degrees of freedom. So a decrease is insignificant if it is below
/// Options::noise_tolerance · s². In the same measure, n estimates differ from the true values by about n s².
/// So if there are more than 100,000 unknowns, the limit grows in proportion to their number.
class Significance {
 public:
  /// `tolerance` is Options::noise_tolerance.
  Significance(double tolerance, double degrees_of_freedom, double unknowns)
      : tolerance_(tolerance * std::max(1.0, unknowns / kManyUnknowns) / std::max(1.0, degrees_of_freedom)) {}

  /// Records an iteration. Returns true if the actual and the predicted decreases of the last two iterations
  /// are insignificant, or if the sum of these decreases over the last ten iterations is insignificant.
  /// Returns false if the decreases grow, because then a small trust region has limited them.
  bool is_lost(const IterationRecord& record) {
    std::rotate(gains_.begin(), gains_.end() - 1, gains_.end());
    gains_[0] = std::max(std::abs(record.chi2_decrease), record.predicted_decrease);
    count_ = std::min(count_ + 1, gains_.size());
    const double each = std::min(kMostOfOne, tolerance_) * record.chi2;
    if (count_ >= 2 && gains_[0] <= gains_[1] && gains_[1] <= each) return true;
    const double together = std::min(kMostOfTen, 10 * tolerance_) * record.chi2;
    const auto half = gains_.begin() + gains_.size() / 2;
    const double recent = std::accumulate(gains_.begin(), half, 0.0);
    const double before = std::accumulate(half, gains_.end(), 0.0);
    return count_ == gains_.size() && recent <= 2 * before && recent + before <= together;
  }

 private:
  /// Decreases above these fractions of chi2 are always significant.
  static constexpr double kMostOfOne = 2e-7, kMostOfTen = 5e-6;
  static constexpr double kManyUnknowns = 1e5;

  double tolerance_;                // the largest insignificant decrease, as a fraction of chi2
  std::array<double, 10> gains_{};  // the decreases in the last iterations, with the latest one first
  std::size_t count_ = 0;
};

}  // namespace boxplus
