// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <type_traits>

#include "boxplus/autodiff/dual.h"

namespace boxplus {
namespace {

using D2 = detail::Dual<double, 2>;
using D1 = detail::Dual<double, 1>;

const D2 kX = D2::variable(3, 0);
const D2 kY = D2::variable(4, 1);

void expect_dual(const D2& actual, double value, double d0, double d1) {
  EXPECT_DOUBLE_EQ(actual.value, value);
  EXPECT_DOUBLE_EQ(actual.derivative[0], d0);
  EXPECT_DOUBLE_EQ(actual.derivative[1], d1);
}

TEST(Dual, FollowsTheRulesOfDifferentiation) {
  expect_dual(kX + kY, 7, 1, 1);
  expect_dual(kX - kY, -1, 1, -1);
  expect_dual(kX * kY, 12, 4, 3);
  expect_dual(kX / kY, 0.75, 0.25, -3.0 / 16);
  expect_dual(-kX, -3, -1, 0);
  expect_dual(+kX, 3, 1, 0);
}

TEST(Dual, CombinesWithEveryArithmeticType) {
  expect_dual(2 * kX + 1, 7, 2, 0);
  expect_dual(1.5f + kX * 2u, 7.5, 2, 0);
  expect_dual(1 - kX, -2, -1, 0);
  expect_dual(kX - 1L, 2, 1, 0);
  expect_dual(6 / kX, 2, -6.0 / 9, 0);
  expect_dual(kX / 2, 1.5, 0.5, 0);
}

TEST(Dual, AssignsInPlace) {
  D2 z = kX;
  z += kY;
  z -= 1;
  z *= kX;
  z /= 2;
  z += 1;
  z -= kX;
  z /= kY;
  z *= 4;
  expect_dual(z, 7, 3.5, -0.25);
  z = kX;
  z *= z;
  expect_dual(z, 9, 6, 0);
}

TEST(Dual, ComparesValuesOnly) {
  EXPECT_TRUE(kX < kY);
  EXPECT_TRUE(kX < 4);
  EXPECT_TRUE(2 < kX);
  EXPECT_TRUE(kX >= 3.0);
  EXPECT_TRUE(kX == 3);
  EXPECT_TRUE(kX != kY);
  EXPECT_TRUE(kX == D2(3));
}

TEST(Dual, IsATrivialTypeWithoutPadding) {
  static_assert(std::is_trivially_copyable_v<D2>);
  static_assert(std::is_trivially_default_constructible_v<D2>);
  static_assert(sizeof(D2) == 3 * sizeof(double));
  expect_dual(D2{}, 0, 0, 0);
  expect_dual(D2(5), 5, 0, 0);
}

TEST(Dual, WorksInConstantExpressions) {
  constexpr D2 square = D2::variable(3, 0) * D2::variable(3, 0);
  static_assert(square.value == 9 && square.derivative[0] == 6);
}

TEST(Dual, ScalarValueIsTheInnermostValue) {
  EXPECT_EQ(detail::scalar_value(2), 2.0);
  EXPECT_EQ(detail::scalar_value(kX), 3.0);
  EXPECT_EQ(detail::scalar_value(detail::Dual<detail::Dual<D1, 2>, 3>(7)), 7.0);
}

/// x y² + sin(x) y.
template <class S>
S polynomial(const S& x, const S& y) {
  using std::sin;
  return x * y * y + sin(x) * y;
}

TEST(Dual, ComputesTheHessianIfItIsNested) {
  using H = detail::Dual<D2, 2>;
  H x(D2::variable(3, 0)), y(D2::variable(4, 1));
  x.derivative[0] = D2(1);
  y.derivative[1] = D2(1);
  const H f = polynomial(x, y);
  EXPECT_DOUBLE_EQ(f.value.value, 48 + 4 * std::sin(3));
  EXPECT_DOUBLE_EQ(f.value.derivative[0], 16 + 4 * std::cos(3));
  EXPECT_DOUBLE_EQ(f.derivative[0].value, 16 + 4 * std::cos(3));
  EXPECT_DOUBLE_EQ(f.derivative[0].derivative[0], -4 * std::sin(3));
  EXPECT_DOUBLE_EQ(f.derivative[0].derivative[1], 8 + std::cos(3));
  EXPECT_DOUBLE_EQ(f.derivative[1].derivative[0], 8 + std::cos(3));
  EXPECT_DOUBLE_EQ(f.derivative[1].derivative[1], 6);
}

TEST(Dual, CombinesWithEveryInnerScalarIfItIsNested) {
  using H = detail::Dual<D1, 2>;
  const H x(D1::variable(3, 0));
  const H f = 2 * x + x * D1(2) + 1.0 - D1(1) / x;
  EXPECT_DOUBLE_EQ(f.value.value, 13 - 1.0 / 3);
  EXPECT_DOUBLE_EQ(f.value.derivative[0], 4 + 1.0 / 9);
  EXPECT_TRUE(x > D1(2));
  EXPECT_TRUE(x > 2);
}

}  // namespace
}  // namespace boxplus
