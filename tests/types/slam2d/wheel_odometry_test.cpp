// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam2d/wheel_odometry.h"

#include <gmock/gmock.h>

#include "types/expect_jacobians.h"

namespace boxplus {
namespace {

TEST(WheelOdometry, DrivesStraightWithEqualSpeeds) {
  const SE2 motion = WheelOdometry({2, 2, 0.5}).motion(DifferentialDrive{});
  EXPECT_EQ(motion.vector(), Vector3(1, 0, 0));
}

TEST(WheelOdometry, TurnsOnTheSpotWithOppositeSpeeds) {
  const SE2 motion = WheelOdometry({-1, 1, 0.5}).motion(DifferentialDrive{1, 1, 2});
  EXPECT_EQ(motion.vector(), Vector3(0, 0, 0.5));
}

TEST(WheelOdometry, DrivesAQuarterCircle) {
  // Radius 2, baseline 1: the wheels run on circles of radius 1.5 and 2.5.
  const SE2 motion = WheelOdometry({1.5, 2.5, kPi / 2}).motion(DifferentialDrive{});
  EXPECT_NEAR(motion.x(), 2, 1e-14);
  EXPECT_NEAR(motion.y(), 2, 1e-14);
  EXPECT_NEAR(motion.theta(), kPi / 2, 1e-14);
}

TEST(WheelOdometry, HasCorrectJacobiansForSmallAndLargeTurns) {
  const SE2 a(1, 2, 0.5), b(2, 2.5, 0.8);
  for (double right : {1.0, 1.0001, 1.01, 1.02, 1.5}) {
    expect_correct_jacobians(WheelOdometry({1, right, 0.5}), a, b, DifferentialDrive{1, 1, 0.5});
  }
}

}  // namespace
}  // namespace boxplus
