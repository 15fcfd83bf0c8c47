// SPDX-License-Identifier: BSD-3-Clause
#include "io/as_printed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "boxplus/manifold/se3.h"
#include "boxplus/manifold/so2.h"

namespace boxplus {
namespace {

// The largest k for which a double holds 10^k exactly. Up to this k, n / 10^k is the same double as the one
// that a reader gets from the decimal text.
constexpr int kMostExactDecimals = 22;
constexpr auto kPowers = [] {
  std::array<double, kMostExactDecimals + 1> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 10 * powers[k - 1];
  return powers;
}();

double rounded(double x, int decimals) {
  const double power = kPowers[decimals];
  return std::nearbyint(x * power) / power;
}

/// The number of decimals with which x has `digits` significant digits.
int decimals_of(double x, int digits) {
  int decimals = digits;  // for 0.1 ≤ |x| < 1
  for (double least = 0.1; decimals < kMostExactDecimals && std::abs(x) < least && x != 0; least /= 10)
    ++decimals;
  return std::abs(x) >= 1 ? digits - 1 : decimals;
}

using Numbers = std::array<double, 4>;
using Decimals = std::array<int, 4>;

Numbers normalized_numbers(const Numbers& q) {
  const detail::Quaternion<double> unit =
      SE3(Vector3(0, 0, 0), detail::Quaternion<double>{q[0], q[1], q[2], q[3]}).quaternion();
  return {unit.x, unit.y, unit.z, unit.w};
}

double length_of(const Numbers& q) {
  return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
}

/// Finds four numbers that are proportional to q and become q when they are normalized. Number i has
/// decimals[i] decimals. `largest` is the index of the largest number of q. The function rounds this number
/// to its decimals, or to one of the two neighboring values; the result determines the factor for all four
/// numbers. Their length differs from 1 by less than `tolerance`.
std::optional<Numbers> printed_with(const Decimals& decimals, const Numbers& q, std::size_t largest,
                                    double tolerance) {
  constexpr double kRoundingNoise = 0.01;
  const double power = kPowers[decimals[largest]];
  for (const double step : {0.0, -1.0, 1.0}) {
    const double factor = (std::nearbyint(q[largest] * power) + step) / power / q[largest];
    Numbers printed;
    bool fits = true;
    for (std::size_t i = 0; i < q.size() && fits; ++i) {
      const double power_i = kPowers[decimals[i]], number = q[i] * factor * power_i;
      printed[i] = std::nearbyint(number) / power_i;
      fits = std::abs(number - std::nearbyint(number)) <= kRoundingNoise;
    }
    fits = fits && std::abs(length_of(printed) - 1) < tolerance;
    if (fits && normalized_numbers(printed) == q) return printed;
  }
  return std::nullopt;
}

}  // namespace

detail::Quaternion<double> as_printed(const detail::Quaternion<double>& q, double tolerance) {
  constexpr int kFewestDigits = 1, kMostDigits = 13;
  const Numbers numbers{q.x, q.y, q.z, q.w};
  const auto by_size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto largest =
      static_cast<std::size_t>(std::max_element(numbers.begin(), numbers.end(), by_size) - numbers.begin());
  for (int digits = kFewestDigits; digits <= kMostDigits; ++digits) {
    Decimals significant{};
    for (std::size_t i = 0; i < numbers.size(); ++i) significant[i] = decimals_of(numbers[i], digits);
    const Decimals fixed{digits, digits, digits, digits};
    for (const Decimals& decimals : {significant, fixed}) {
      if (const auto found = printed_with(decimals, numbers, largest, tolerance))
        return {(*found)[0], (*found)[1], (*found)[2], (*found)[3]};
    }
  }
  return q;
}

double as_printed(double theta) {
  constexpr double kNearPi = 3.1;
  constexpr int kFewest = 2, kMost = 14;
  if (std::abs(theta) < kNearPi) return theta;
  const double beyond = theta > 0 ? theta - 2 * kPi : theta + 2 * kPi;
  for (int decimals = kFewest; decimals <= kMost; ++decimals) {
    if (rounded(theta, decimals) == theta) return theta;
    const double printed = rounded(beyond, decimals);
    if (detail::normalize_angle(printed) == theta) return printed;
  }
  return theta;
}

}  // namespace boxplus
