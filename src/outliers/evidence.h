// SPDX-License-Identifier: BSD-3-Clause
// The evidence that a measured motion is true, from its deviation from an expected motion.
#pragma once

#include <span>
#include <vector>

#include "outliers/pose_graph.h"

namespace boxplus::outliers {

/// A deviation between two motions, and the spread that noise of scale 1 gives it.
struct Deviation {
  double squared_translation = 0;  ///< m²
  double squared_angle = 0;        ///< rad²
  Spread spread;

  static Deviation between(const Motion& expected, const Motion& measured, const Spread& spread) {
    const Motion difference = measured.inverse_times(expected);
    return {difference.translation.squaredNorm(), difference.squared_angle(), spread};
  }
};

/// Compares two explanations of a deviation: the motion is true, so that the deviation has a normal
/// distribution with the variances `scale` · spread; or it is false, and leads anywhere on the map, with any
/// rotation.
class Evidence {
 public:
  /// The extent of the map is taken from the positions of the poses.
  Evidence(const PoseGraph& poses, std::span<const Motion> estimates);

  /// The natural logarithm of p(deviation | true) / p(deviation | false).
  double log_odds(const Deviation& deviation, double scale) const;
  /// The log odds if there were no deviation: the most evidence that such a comparison can give.
  double most(const Spread& spread, double scale) const { return log_odds({0, 0, spread}, scale); }
  /// The scale of the noise that explains the deviations best, if half of them are of false motions. 1 if
  /// there are no deviations.
  double noise_scale(std::span<const Deviation> deviations) const;
  double extent() const { return extent_; }

 private:
  double log_likelihood(std::span<const Deviation> deviations, double scale) const;

  double translations_, rotations_;
  double extent_ = 0;                ///< a typical size of the map in meters
  double log_area_, log_rotations_;  ///< logarithms of the measures of all places and all rotations
  double most_translation_;          ///< variance of a position that may be anywhere
};

}  // namespace boxplus::outliers
