// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/robust/default_width.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

constexpr double kDefaultProbability = 0.95, kLargestProbability = 1 - 1e-9;

/// The density of the gamma distribution with shape a at x > 0, times x: xᵃ e⁻ˣ / Γ(a).
double scaled_density(double a, double x) {
  constexpr double kLarge = 20;
  if (a < kLarge) return std::exp(a * std::log(x) - x - std::lgamma(a));
  // Uses Stirling's series for Γ(a), so that no large terms cancel.
  const double d = (x - a) / a, rest = (1 / 12.0 - (1 / 360.0 - 1 / (1260 * a * a)) / (a * a)) / a;
  return std::exp(a * (std::log1p(d) - d) - rest) * std::sqrt(a / (2 * std::numbers::pi));
}

/// The distribution function of the gamma distribution, the regularized P(a, x), by the series Σ xⁿ / (a
/// (a+1) … (a+n)).
double distribution(double a, double x) {
  double term = 1 / a, sum = term;
  for (double n = 1; term > sum * std::numeric_limits<double>::epsilon(); ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * scaled_density(a, x);
}

}  // namespace

double chi2_quantile(int rows, double probability) {
  if (rows < 1) throw InvalidArgument("chi2_quantile: expected rows ≥ 1, got " + std::to_string(rows));
  if (!(probability > 0 && probability <= kLargestProbability)) {
    throw InvalidArgument("chi2_quantile: expected a probability > 0 and ≤ 1 - 1e-9, got " +
                          std::to_string(probability));
  }
  // Half of a chi2 variable has the gamma distribution with shape rows / 2. Finds its quantile by Newton's
  // method, and by bisection when a step would leave the bracket [low, high].
  const double a = 0.5 * rows, spread = 2 + 2 * std::sqrt(a);
  double low = 0, high = a + spread;
  for (; distribution(a, high) < probability; high += spread) low = high;
  double x = std::max(a, low);
  for (int i = 0; i < 200; ++i) {
    const double excess = distribution(a, x) - probability;
    (excess < 0 ? low : high) = x;
    const double newton = x - excess * x / scaled_density(a, x);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (std::abs(next - x) <= 1e-14 * x) break;
    x = next;
  }
  return 2 * x;
}

double default_width(int rows) {
  return std::sqrt(chi2_quantile(rows, kDefaultProbability));
}

}  // namespace boxplus
