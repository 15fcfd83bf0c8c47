// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/angle.h"

#include <gtest/gtest.h>

#include "boxplus/autodiff/dual.h"

namespace boxplus {
namespace {

TEST(NormalizeAngle, KeepsAnglesInRangeBitForBit) {
  for (const double x : {0.0, 0.1, -3.0, kPi, std::nextafter(-kPi, 0.0)})
    EXPECT_EQ(detail::normalize_angle(x), x);
}

TEST(NormalizeAngle, MapsMinusPiToPi) {
  EXPECT_EQ(detail::normalize_angle(-kPi), kPi);
  EXPECT_EQ(detail::normalize_angle(-3 * kPi), kPi);
}

TEST(NormalizeAngle, RemovesWholeTurns) {
  EXPECT_NEAR(detail::normalize_angle(4.0), 4 - 2 * kPi, 1e-15);
  EXPECT_NEAR(detail::normalize_angle(-4.0), 2 * kPi - 4, 1e-15);
  EXPECT_NEAR(detail::normalize_angle(0.5 + 2000 * kPi), 0.5, 1e-12);
}

TEST(NormalizeAngle, StaysInRangeForEveryAngle) {
  for (double x = -50; x < 50; x += 0.001) {
    const double y = detail::normalize_angle(x);
    EXPECT_TRUE(y > -kPi && y <= kPi) << x;
    EXPECT_NEAR(std::sin(y), std::sin(x), 1e-13);
  }
}

TEST(NormalizeAngle, HasDerivativeOne) {
  using D = detail::Dual<double, 1>;
  EXPECT_EQ(detail::normalize_angle(D::variable(7, 0)).derivative[0], 1);
  EXPECT_EQ(detail::normalize_angle(detail::Dual<D, 1>(D::variable(7, 0))).value.derivative[0], 1);
  EXPECT_EQ(detail::normalize_angle(D(7)).value, detail::normalize_angle(7.0));
}

}  // namespace
}  // namespace boxplus
