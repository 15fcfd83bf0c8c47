// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/rotation_charts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "boxplus/manifold/angle.h"
#include "boxplus/manifold/so3.h"

namespace boxplus {
namespace {

TEST(QuaternionChart, LimitsAStepToHalfATurn) {
  const double far[3] = {0, 3, 4};
  const SO3 x = Manifold<SO3>::oplus(SO3(), far);
  EXPECT_DOUBLE_EQ(x.data()[1], 0.6);
  EXPECT_DOUBLE_EQ(x.data()[2], 0.8);
  EXPECT_EQ(x.data()[3], 0);
  const double unit[3] = {1, 0, 0};
  EXPECT_EQ(Manifold<SO3>::oplus(SO3(), unit).data()[0], 1);
}

TEST(QuaternionChart, MinimalPicksTheSignOfTheQuaternionThatMakesWNonNegative) {
  EXPECT_EQ(SO3(detail::Quaternion<double>{0.6, 0, 0, -0.8}).minimal()[0], -0.6);
  EXPECT_EQ(SO3(detail::Quaternion<double>{0.6, 0, 0, 0.8}).minimal()[0], 0.6);
}

TEST(RotationVectorChart, IsExactOnBothSidesOfTheSwitchToItsTaylorSeries) {
  for (const double angle : {0.0, 1e-9, 1e-4, 0.00999999, 0.01000001, 0.1, 2.0, 3.1}) {
    const detail::Quaternion<double> q = detail::RotationVectorChart::exp(angle, 0.0, 0.0);
    EXPECT_NEAR(q.x, std::sin(angle / 2), 1e-16);
    EXPECT_NEAR(q.w, std::cos(angle / 2), 2e-16);
    EXPECT_NEAR(detail::RotationVectorChart::log(q)[0], angle, 1e-15);
  }
}

TEST(RotationVectorChart, ReturnsAnglesUpToPi) {
  const Vector<double, 3> log =
      detail::RotationVectorChart::log(detail::RotationVectorChart::exp(0.0, 4.0, 0.0));
  EXPECT_NEAR(log[1], 4 - 2 * kPi, 1e-15);
}

}  // namespace
}  // namespace boxplus
