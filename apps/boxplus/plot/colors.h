// SPDX-License-Identifier: BSD-3-Clause
// The colors of pictures, which color-blind people can distinguish. Cold colors show the time along the
// trajectory. Warm colors show errors; larger errors have darker colors.
#pragma once

#include <span>

#include "plot/canvas/canvas.h"
#include "plot/scene.h"

namespace boxplus::app {

inline constexpr Rgb kLandmarkColor{0x1e, 0x29, 0x3b}, kTruthColor{0xf2, 0xd0, 0x6b},
    kScanColor{0x8b, 0x9d, 0xae};

/// Returns the color at a time between the beginning (0) and the end (1) of the trajectory.
Rgb trajectory_color(double time);

/// The color scale for errors, which all scenes share. It is gray up to chi2 = 1 per row, because noise
/// explains such errors. Above 1, it is logarithmic. It ends at the smallest power of ten that is at least as
/// large as 99 % of the errors.
class ErrorColors {
 public:
  static constexpr int kBins = 16;

  explicit ErrorColors(std::span<const Scene> scenes);

  /// Returns the index of the color, from 0 to kBins − 1. NaN has the last color.
  int bin(double chi2_per_row) const;
  static Rgb color(int bin);
  /// The same for points. The color of small errors is darker, so that a cloud of good points is easy to see.
  static Rgb point_color(int bin);
  /// Returns log₁₀ of the chi2 per row at which the scale ends. Larger values have the darkest color.
  int decades() const { return decades_; }

 private:
  int decades_ = 1;
};

}  // namespace boxplus::app
