// SPDX-License-Identifier: BSD-3-Clause
// The colors of pictures, distinguishable for color-blind eyes: time is cold; errors are warm, and the
// larger, the darker.
#pragma once

#include <span>

#include "plot/canvas/canvas.h"
#include "plot/scene.h"

namespace boxplus::app {

inline constexpr Rgb kLandmarkColor{0x1e, 0x29, 0x3b}, kTruthColor{0xf2, 0xd0, 0x6b};

/// The color at a time between the beginning (0) and the end (1) of the trajectory.
Rgb trajectory_color(double time);

/// One color scale for all scenes. It is gray up to chi2 = 1 per row, which noise explains. From there it is
/// logarithmic, up to the smallest power of ten that is above 99 % of the scenes' errors.
class ErrorColors {
 public:
  static constexpr int kBins = 16;

  explicit ErrorColors(std::span<const Scene> scenes);

  /// 0 … kBins − 1; NaN gives the last bin.
  int bin(double chi2_per_row) const;
  static Rgb color(int bin);
  /// log₁₀ of the smallest chi2 per row with the darkest color.
  int decades() const { return decades_; }

 private:
  int decades_ = 1;
};

}  // namespace boxplus::app
