// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "boxplus/optimize/options.h"

namespace boxplus {

/// Tells when what the iterations of a run gain no longer matters against the noise of the measurements.
///
/// Were Ω right, a fall of chi2 by 1 would move the estimates by one standard deviation in one direction. If
/// Ω is only right up to a factor, that is a fall by the variance s² = chi2 / degrees of freedom.
class Significance {
 public:
  /// `tolerance` as Options::noise_tolerance.
  Significance(double tolerance, double degrees_of_freedom)
      : tolerance_(tolerance / std::max(1.0, degrees_of_freedom)) {}

  /// Takes note of an iteration; true if neither this one and the one before, nor the last ten together,
  /// lowered chi2 significantly or were predicted to. The gains of a sequence that grows do not count: it
  /// comes out of too small a trust region.
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
  /// Fractions of chi2 that matter in any case.
  static constexpr double kMostOfOne = 2e-7, kMostOfTen = 5e-6;

  double tolerance_;                // as a fraction of chi2
  std::array<double, 10> gains_{};  // the last one first
  std::size_t count_ = 0;
};

}  // namespace boxplus
