// SPDX-License-Identifier: BSD-3-Clause
#include "base/double_double.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace boxplus {
namespace {

constexpr double kEpsilon = 1e-31;

TEST(DoubleDouble, KeepsWhatADoubleLoses) {
  const DoubleDouble x = DoubleDouble(1e18) + 1.0 + 0x1p-40;
  EXPECT_EQ(static_cast<double>(x - 1e18), 1 + 0x1p-40);
  EXPECT_EQ(static_cast<double>(DoubleDouble::product(1e9 + 1, 1e9 + 1) - 1e18), 2e9 + 1);
}

TEST(DoubleDouble, DividesAndMultipliesWithThirtyOneDigits) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> uniform(-1, 1);
  const auto number = [&] {
    const double high = std::ldexp(uniform(random), static_cast<int>(20 * uniform(random)));
    return DoubleDouble(high) + std::ldexp(high * uniform(random), -54);
  };
  for (int i = 0; i < 1000; ++i) {
    const DoubleDouble a = number(), b = number();
    const DoubleDouble quotient_error = a / b * b - a, product_error = a * b / b - a;
    EXPECT_LE(std::abs(quotient_error.high), kEpsilon * std::abs(a.high));
    EXPECT_LE(std::abs(product_error.high), kEpsilon * std::abs(a.high));
  }
}

TEST(DoubleDouble, SatisfiesTheBinomialFormula) {
  const DoubleDouble a = DoubleDouble(1) / 3.0, b = DoubleDouble(1e9) / 7.0;
  const DoubleDouble error = (a + b) * (a - b) - (a * a - b * b);
  EXPECT_LE(std::abs(error.high), kEpsilon * b.high * b.high);
}

}  // namespace
}  // namespace boxplus
