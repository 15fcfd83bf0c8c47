// SPDX-License-Identifier: BSD-3-Clause
// The colours of pictures, chosen to stay apart for colour-blind eyes: time is cold, errors are warm, and the
// larger the darker.
#pragma once

#include <span>
#include <string>

#include "plot/scene.h"

namespace boxplus::app {

inline constexpr const char* kLandmarkColour = "#1e293b";

/// From the beginning (0) to the end (1) of the trajectory.
std::string trajectory_colour(double time);

/// One scale of colours for all scenes: grey up to chi2 = 1 per row, what noise explains, then by the
/// logarithm up to the power of ten that 99 % of their errors are below.
class ErrorColours {
 public:
  static constexpr int kBins = 16;

  explicit ErrorColours(std::span<const Scene> scenes);

  /// 0 … kBins − 1. What is no number is as bad as can be.
  int bin(double chi2_per_row) const;
  static std::string colour(int bin);
  /// log₁₀ of the least chi2 per row that has the darkest colour.
  int decades() const { return decades_; }

 private:
  int decades_ = 1;
};

}  // namespace boxplus::app
