// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/roughness.h"

#include <cmath>

namespace boxplus {
namespace {

/// |F(x ⊞ fraction · step) − F(x)|
double change_by(System& system, std::span<double> step, double fraction, double chi2) {
  for (double& entry : step) entry *= fraction;
  const double change = std::abs(chi2 - system.try_step(step));
  system.reject();
  for (double& entry : step) entry /= fraction;
  return change;
}

}  // namespace

bool is_rough(System& system, std::span<double> step, double predicted, double chi2) {
  if (!(predicted > 0)) return false;
  // Powers of two, so that the entries of the step have the same bits afterwards. The first fraction finds
  // steps of less than 1e-12 of the estimates. The others are for functions that are smooth only nearby.
  double expected = 1;  // then the slope at the last fraction, because wrong Jacobians predict a wrong slope
  for (const double fraction : {0x1p-13, 0x1p-24, 0x1p-36}) {
    const double slope = change_by(system, step, fraction, chi2) / (2 * fraction * predicted);
    const auto is_near = [slope](double value) { return slope > value / 2 && slope < value * 2; };
    if (!std::isfinite(slope) || is_near(1) || is_near(expected)) return false;
    expected = slope;
  }
  return true;
}

}  // namespace boxplus
