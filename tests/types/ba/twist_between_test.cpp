// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/twist_between.h"

#include <gmock/gmock.h>

#include "boxplus/manifold/convert_to.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

SE3RotationVector vector_pose(double x, double y, double z, double rx, double ry, double rz) {
  return convert_to<SE3RotationVector>(pose(x, y, z, rx, ry, rz));
}

TEST(TwistBetween, IsTheVelocityInTheWorldFromThePredictedPoseToTheSecondOne) {
  // a z is at (1, 0, 0). A quarter turn about the world's z axis moves it to (0, 1, 0); then 3 m along z.
  const SE3RotationVector a = vector_pose(0, 0, 0, 0, 0, kPi / 2), b = vector_pose(0, 1, 3, 0, 0, kPi);
  const Vector<double, 6> e = TwistBetween(pose(0, -1, 0, 0, 0, 0)).error(a, b);
  Vector<double, 6> expected;
  expected << 0, 0, kPi / 2, 0, 0, 3;
  EXPECT_LT((e - expected).norm(), 1e-14);
}

TEST(TwistBetween, HasCorrectJacobians) {
  const TwistBetween edge(pose(1, 2, 3, 0.5, -0.2, 0.8));
  expect_correct_jacobians(edge, vector_pose(1, 0, 2, 0.1, 0.7, -0.3), vector_pose(3, 1, 2, -0.4, 0.6, 1));
  expect_correct_jacobians(edge, pose(1, 0, 2, 0.1, 0.7, -0.3), pose(3, 1, 2, -0.4, 0.6, 1));
}

TEST(TwistBetween, PredictsTheSecondPose) {
  const SE3RotationVector a = vector_pose(1, 2, 3, 0.5, -0.2, 0.8);
  const SE3 z = pose(3, 1, 2, -0.4, 0.6, 1);
  const detail::RelativeFrame relative = TwistBetween(z).relative_frame(a, a);
  EXPECT_EQ(relative.rotation_row, 0);
  EXPECT_EQ(relative.translation_row, 3);
  EXPECT_LT(TwistBetween(z).error(a, a * convert_to<SE3RotationVector>(z)).norm(), 1e-13);
}

}  // namespace
}  // namespace boxplus
