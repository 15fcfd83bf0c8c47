// SPDX-License-Identifier: BSD-3-Clause
#include "algorithm/roughness.h"

#include <algorithm>
#include <cmath>

namespace boxplus {
namespace {

/// F(x) − F(x ⊞ fraction · step). The entries of the step may change by rounding errors unless the fraction
/// is a power of two.
double decrease_by(System& system, std::span<double> step, double fraction, double chi2) {
  for (double& entry : step) entry *= fraction;
  const double decrease = chi2 - system.try_step(step);
  system.reject();
  for (double& entry : step) entry /= fraction;
  return decrease;
}

/// Whether F falls along the step as the model predicts, for three fractions in a row. Then the step is only
/// too long. Rounding errors hardly ever look so.
bool falls_nearby(System& system, std::span<double> step, double predicted, double chi2) {
  constexpr int kInARow = 3, kHalvings = 10;
  int found = 0;
  for (int halvings = 1; halvings <= kHalvings; ++halvings) {
    const double fraction = std::ldexp(1.0, -halvings);
    const double slope = decrease_by(system, step, fraction, chi2) / (2 * fraction * predicted);
    if (!std::isfinite(slope)) return true;
    found = slope > 0.1 && slope < 2 ? found + 1 : 0;
    if (found == kInARow) return true;
  }
  return false;
}

/// Whether F changes smoothly around the end of the step, by more than a negligible part. Then the step is
/// far too long, but no rounding error. The fourth difference of a smooth function is small.
bool is_smooth_at_end(System& system, std::span<double> step, double chi2) {
  constexpr double kSmall = 0.05;
  constexpr double kWeights[] = {1, -4, 6, -4, 1};
  double fraction = 0.5, difference = 0, largest = 0;
  for (const double weight : kWeights) {
    const double decrease = decrease_by(system, step, fraction, chi2);
    difference += weight * decrease;
    largest = std::max(largest, std::abs(decrease));
    fraction += 0.25;
  }
  return largest > kNegligible * chi2 && std::abs(difference) <= kSmall * largest;
}

}  // namespace

bool is_rough(System& system, std::span<double> step, double predicted, double chi2) {
  if (!(predicted > 0)) return false;
  // Powers of two, so that the entries of the step have the same bits afterwards. The first fraction finds
  // steps of less than 1e-12 of the estimates. The others are for functions that are smooth only nearby.
  double previous = 0;  // wrong Jacobians predict a wrong slope, but the slope is the same at two fractions
  for (const double fraction : {0x1p-13, 0x1p-24, 0x1p-36}) {
    const double slope = decrease_by(system, step, fraction, chi2) / (2 * fraction * predicted);
    const bool is_predicted = slope > 0.5 && slope < 2;
    const bool is_constant = std::abs(slope - previous) < std::abs(previous) / 8;
    if (!std::isfinite(slope) || is_predicted || is_constant) return false;
    previous = slope;
  }
  return !is_smooth_at_end(system, step, chi2) && !falls_nearby(system, step, predicted, chi2);
}

}  // namespace boxplus
