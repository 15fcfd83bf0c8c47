// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/ba/camera_between.h"

#include <gmock/gmock.h>

#include "boxplus/types/range.h"
#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

StereoPose camera_at(const SE3& x) {
  return {x, {Vector<double, 4>(100, 200, 30, 40), 0.2}};
}

const StereoPose kA = camera_at(pose(1, 2, 3, 0, 0, kPi / 2)), kB = camera_at(pose(1, 5, 7, 0, 0, kPi / 2));

TEST(CameraBetween, IsTheErrorOfTheRelativePose) {
  // b is at (3, 0, 4) in the frame of a.
  const Vector<double, 6> e = CameraBetween(pose(1, 0, 2, 0, 0, 0)).error(kA, kB);
  Vector<double, 6> expected;
  expected << 2, 0, 2, 0, 0, 0;
  EXPECT_LT((e - expected).norm(), 1e-14);
}

TEST(Range, MeasuresTheDistanceBetweenStereoCameras) {
  EXPECT_NEAR(Range(3).error(kA, kB), 2, 1e-14);
}

TEST(EdgesBetweenStereoCameras, HaveCorrectJacobians) {
  const StereoPose c = camera_at(pose(3, 1, 2, -0.4, 0.6, 1));
  expect_correct_jacobians(CameraBetween(pose(1, 2, 3, 0.5, -0.2, 0.8)), kA, c);
  expect_correct_jacobians(Range(3), kA, c);
}

TEST(CameraBetween, PredictsTheSecondPose) {
  const SE3 z = pose(1, 2, 3, 0.5, -0.2, 0.8);
  const detail::RelativeFrame relative = CameraBetween(z).relative_frame(kA, kB);
  EXPECT_EQ(relative.translation_row, 0);
  EXPECT_EQ(relative.rotation_unit, 0.5);
  EXPECT_LT(CameraBetween(z).error(kA, camera_at(kA.pose * z)).norm(), 1e-13);
}

}  // namespace
}  // namespace boxplus
