// SPDX-License-Identifier: BSD-3-Clause
// The colors of pictures, chosen to stay apart for color-blind eyes: time is cold, errors are warm, and the
// larger the darker.
#pragma once

#include <span>

#include "plot/canvas/canvas.h"
#include "plot/scene.h"

namespace boxplus::app {

inline constexpr Rgb kLandmarkColor{0x1e, 0x29, 0x3b}, kTruthColor{0xf2, 0xd0, 0x6b};

/// From the beginning (0) to the end (1) of the trajectory.
Rgb trajectory_color(double time);

/// One scale of colors for all scenes: grey up to chi2 = 1 per row, what noise explains, then by the
/// logarithm up to the power of ten that 99 % of their errors are below.
class ErrorColors {
 public:
  static constexpr int kBins = 16;

  explicit ErrorColors(std::span<const Scene> scenes);

  /// 0 … kBins − 1. What is no number is as bad as can be.
  int bin(double chi2_per_row) const;
  static Rgb color(int bin);
  /// log₁₀ of the least chi2 per row that has the darkest color.
  int decades() const { return decades_; }

 private:
  int decades_ = 1;
};

}  // namespace boxplus::app
