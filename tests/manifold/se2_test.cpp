// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/manifold/se2.h"

#include <gtest/gtest.h>

#include "boxplus/testing/check_manifold.h"
#include "manifold/samples.h"

namespace boxplus {
namespace {

SE2 random_pose(Samples& s) {
  return {s.uniform(-10, 10), s.uniform(-10, 10), s.uniform(-kPi, kPi)};
}

TEST(SE2, ObeysTheManifoldLaws) {
  Samples s;
  auto poses = Samples::many(10, [&] { return random_pose(s); });
  poses.push_back(SE2(1, 2, kPi));
  const ManifoldCheck check = check_manifold(poses);
  EXPECT_TRUE(check) << check.message;
}

TEST(SE2, KeepsAHeadingInRangeBitForBitAndNormalizesOthers) {
  EXPECT_EQ(SE2(0, 0, kPi).theta(), kPi);
  EXPECT_EQ(SE2(0, 0, -3.1).theta(), -3.1);
  EXPECT_EQ(SE2(0, 0, -kPi).theta(), kPi);
  EXPECT_NEAR(SE2(0, 0, 4).theta(), 4 - 2 * kPi, 1e-15);
}

TEST(SE2, MovesInItsOwnFrame) {
  const double delta[] = {1, 0, 0.1};
  const SE2 moved = Manifold<SE2>::oplus(SE2(2, 3, kPi / 2), delta);
  EXPECT_NEAR(moved.x(), 2, 1e-15);
  EXPECT_NEAR(moved.y(), 4, 1e-15);
  EXPECT_DOUBLE_EQ(moved.theta(), kPi / 2 + 0.1);
}

TEST(SE2, IsUnchangedBitForBitByAZeroStep) {
  Samples s;
  const double zero[3] = {0, 0, 0};
  for (int i = 0; i < 100; ++i) {
    const SE2 x = random_pose(s);
    EXPECT_EQ(Manifold<SE2>::oplus(x, zero).vector(), x.vector());
  }
}

TEST(SE2, ComposesLikeItsMatrices) {
  Samples s;
  const SE2 a = random_pose(s), b = random_pose(s);
  const Vector<double, 2> p(0.3, -2);
  EXPECT_LT(((a * b) * p - a * (b * p)).norm(), 1e-14);
  EXPECT_LT((a * p - (a.rotation() * p + a.translation())).norm(), 1e-14);
  EXPECT_LT((a.inverse() * (a * p) - p).norm(), 1e-14);
  EXPECT_LT((a.inverse_times(p) - a.inverse() * p).norm(), 1e-14);
  EXPECT_LT((a.inverse_times(b).vector() - (a.inverse() * b).vector()).norm(), 1e-14);
  EXPECT_EQ(SE2::from_vector(a.vector()).vector(), a.vector());
}

TEST(SE2, HasExactJacobiansFromDualNumbers) {
  Samples s;
  const SE2 measurement = random_pose(s), a = random_pose(s), b = random_pose(s);
  const auto error = [&](const auto& x) {
    return (measurement.inverse() * (a.inverse() * (x * b))).vector();
  };
  Matrix<double, 3, 3> numeric;
  detail::numeric_jacobian(error, a, numeric);
  EXPECT_LT((dual_jacobian<3>(error, a) - numeric).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SE2, HasAnExponentialWhoseInverseIsTheLogarithm) {
  for (const double angle : {0.0, 1e-9, 0.009, 0.011, -1.0, 3.1}) {
    const Vector<double, 3> v(1, -2, angle);
    const SE2 x = SE2::exp(v), half = SE2::exp(0.5 * v);
    EXPECT_LT((x.log() - v).norm(), 1e-14) << angle;
    EXPECT_LT(((half * half).vector() - x.vector()).norm(), 1e-14) << angle;
  }
}

TEST(SE2, MovesOnACircleIfItsVelocitiesAreConstant) {
  const SE2 quarter = SE2::exp(Vector<double, 3>(kPi, 0, kPi / 2));  // of a circle with radius 2, to the left
  EXPECT_LT((quarter.vector() - Vector<double, 3>(2, 2, kPi / 2)).norm(), 1e-15);
}

}  // namespace
}  // namespace boxplus
