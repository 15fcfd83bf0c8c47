// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/roughness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "optimize/outcome.h"
#include "optimize/vector_math.h"

namespace boxplus {
namespace {

/// F(x) − F(x ⊞ fraction · step)
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

/// A step of the length `length` · √F in the norm of D, along all entries that `step` moves.
std::vector<double> short_step(const System& system, std::span<const double> step, double length,
                               double chi2) {
  constexpr double kMeasured = 1e-20;  // of the largest entry of D; below are only rounding errors
  const std::span<const double> scale = system.scale();
  const double least = kMeasured * max_abs(scale);
  const auto moves = [&](std::size_t i) { return step[i] != 0 && scale[i] > least; };
  std::size_t moved = 0;
  for (std::size_t i = 0; i < step.size(); ++i) moved += moves(i);
  const double size = length * std::sqrt(chi2 / static_cast<double>(std::max<std::size_t>(moved, 1)));
  std::vector<double> result(step.size());
  std::uint32_t bits = 1;  // of a linear congruential generator, for the signs
  for (std::size_t i = 0; i < step.size(); ++i) {
    bits = 1664525 * bits + 1013904223;
    if (moves(i)) result[i] = (bits >> 31 != 0 ? size : -size) / std::sqrt(scale[i]);
  }
  return result;
}

/// The size of the rounding errors of F: the part of F(x ⊞ δ) + F(x ⊞ −δ) − 2F(x) that the model does not
/// predict, for short steps δ. Near large coordinates, the shortest ones do not change the estimates.
double rounding_of(System& system, std::span<const double> step, double chi2) {
  double largest = 0;
  for (const double length : {1e-8, 1e-6, 1e-4}) {
    std::vector<double> probe = short_step(system, step, length, chi2);
    const double ahead = decrease_by(system, probe, 1, chi2), behind = decrease_by(system, probe, -1, chi2);
    largest = std::max(largest, std::abs(ahead + behind + 2 * system.curvature(probe)));
  }
  return largest;
}

/// Whether a change of F is no larger than rounding errors. (Negligible changes spare their measurement.)
bool is_rounding(System& system, std::span<const double> step, double change, double chi2) {
  constexpr double kTimes = 30;
  return change <= kNegligible * chi2 || change <= kTimes * rounding_of(system, step, chi2);
}

}  // namespace

bool is_rough(System& system, std::span<double> step, double predicted, double chi2) {
  if (!(predicted > 0)) return false;
  // Powers of two, so that the entries of the step have the same bits afterwards. The first fraction finds
  // steps of less than 1e-12 of the estimates. The others are for functions that are smooth only nearby.
  double largest = std::abs(decrease_by(system, step, 1, chi2));
  double previous = 0;  // wrong Jacobians predict a wrong slope, but the slope is the same at two fractions
  for (const double fraction : {0x1p-13, 0x1p-24, 0x1p-36}) {
    const double decrease = decrease_by(system, step, fraction, chi2);
    const double slope = decrease / (2 * fraction * predicted);
    const bool is_predicted = slope > 0.5 && slope < 2;
    const bool is_constant = std::abs(slope - previous) < std::abs(previous) / 8;
    if (!std::isfinite(slope) || is_predicted || is_constant) return false;
    previous = slope;
    largest = std::max(largest, std::abs(decrease));
  }
  return std::isfinite(largest) && is_rounding(system, step, largest, chi2) &&
         !falls_nearby(system, step, predicted, chi2);
}

}  // namespace boxplus
