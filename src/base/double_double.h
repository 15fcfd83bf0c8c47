// SPDX-License-Identifier: BSD-3-Clause
// Numbers with about 32 digits: unevaluated sums of two doubles.
#pragma once

#include <cmath>

namespace boxplus {

/// The number high + low, where |low| is at most half a unit in the last place of `high`. The relative error
/// of each operation is a few 2⁻¹⁰⁴. The range is that of double. (Dekker, "A floating-point technique for
/// extending the available precision", 1971.)
struct DoubleDouble {
  double high = 0, low = 0;

  DoubleDouble() = default;
  DoubleDouble(double value) : high(value) {}
  DoubleDouble(double high_part, double low_part) : high(high_part), low(low_part) {}
  explicit operator double() const { return high; }

  /// The exact sum.
  static DoubleDouble sum(double a, double b) {
    const double s = a + b, t = s - a;
    return {s, (a - (s - t)) + (b - t)};
  }
  /// The exact sum if |a| ≥ |b|.
  static DoubleDouble ordered_sum(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  /// The exact product, unless it underflows.
  static DoubleDouble product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  DoubleDouble operator-() const { return {-high, -low}; }
  DoubleDouble& operator+=(const DoubleDouble& b) {
    const DoubleDouble s = sum(high, b.high), t = sum(low, b.low);
    const DoubleDouble u = ordered_sum(s.high, s.low + t.high);
    return *this = ordered_sum(u.high, u.low + t.low);
  }
  DoubleDouble& operator-=(const DoubleDouble& b) { return *this += -b; }
  DoubleDouble& operator*=(const DoubleDouble& b) {
    const DoubleDouble p = product(high, b.high);
    return *this = ordered_sum(p.high, p.low + (high * b.low + low * b.high));
  }
  DoubleDouble& operator/=(const DoubleDouble& b) {
    const double first = high / b.high;
    DoubleDouble rest = *this - first * b;
    const double second = rest.high / b.high;
    rest -= second * b;
    return *this = ordered_sum(first, second) + DoubleDouble(rest.high / b.high);
  }

  friend DoubleDouble operator+(DoubleDouble a, const DoubleDouble& b) { return a += b; }
  friend DoubleDouble operator-(DoubleDouble a, const DoubleDouble& b) { return a -= b; }
  friend DoubleDouble operator*(DoubleDouble a, const DoubleDouble& b) { return a *= b; }
  friend DoubleDouble operator/(DoubleDouble a, const DoubleDouble& b) { return a /= b; }
};

}  // namespace boxplus
