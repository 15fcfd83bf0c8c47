// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/trajectory_errors.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

TrajectoryPose pose_at(double x, double y, double angle = 0) {
  TrajectoryPose pose;
  pose.position = {x, y, 0};
  pose.rotation = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

/// A true path along the sides of a square, and a result that is 0.1 m too high at two of the corners.
std::vector<PosePair> square() {
  return {{pose_at(0, 0.1), pose_at(0, 0)},
          {pose_at(1, -0.1), pose_at(1, 0)},
          {pose_at(1, 1.1), pose_at(1, 1)},
          {pose_at(0, 0.9), pose_at(0, 1)}};
}

Alignment some_motion() {
  Alignment motion;
  motion.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
  motion.translation = {30, -20, 5};
  return motion;
}

TEST(ErrorStatistics, HaveTheMedianOfOddAndEvenNumbersOfErrors) {
  const ErrorStatistics odd = error_statistics({3, 1, 2}), even = error_statistics({4, 1, 3, 10});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(even.median, 3.5);
  EXPECT_EQ(even.max, 10);
  EXPECT_EQ(even.mean, 4.5);
  EXPECT_NEAR(even.rmse, std::sqrt(126.0 / 4), 1e-15);
  EXPECT_EQ(error_statistics({}).median, 0);
}

TEST(AbsoluteError, IsTheDistanceAfterTheAlignment) {
  const std::vector<PosePair> pairs = square();
  const Alignment motion = align_poses(pairs, 2, AlignmentKind::kRigid, false);
  EXPECT_TRUE(motion.translation.isZero(1e-12));
  EXPECT_TRUE(motion.rotation.isIdentity(1e-12));
  const ErrorStatistics errors = absolute_error(pairs, motion);
  EXPECT_EQ(errors.count, 4U);
  EXPECT_NEAR(errors.rmse, 0.1, 1e-12);
  EXPECT_NEAR(errors.max, 0.1, 1e-12);
}

TEST(AbsoluteError, DoesNotChangeIfTheWholeResultMoves) {
  std::vector<PosePair> pairs = square();
  const Alignment motion = some_motion();
  for (PosePair& pair : pairs) pair.result = motion(pair.result);
  const Alignment back = align_poses(pairs, 3, AlignmentKind::kRigid, false);
  EXPECT_NEAR(absolute_error(pairs, back).rmse, 0.1, 1e-12);
  EXPECT_GT(absolute_error(pairs, {}).rmse, 10);
}

TEST(AbsoluteError, IsZeroForAScaledResultOnlyIfTheScaleIsEstimated) {
  std::vector<PosePair> pairs = square();
  for (PosePair& pair : pairs) {
    pair.result = pair.truth;
    pair.result.position *= 0.5;
  }
  EXPECT_GT(absolute_error(pairs, align_poses(pairs, 2, AlignmentKind::kRigid, false)).rmse, 0.1);
  const Alignment scaled = align_poses(pairs, 2, AlignmentKind::kRigid, true);
  EXPECT_NEAR(scaled.scale, 2, 1e-12);
  EXPECT_NEAR(absolute_error(pairs, scaled).max, 0, 1e-12);
}

TEST(RelativeError, IsTheErrorOfTheMotionFromPoseToPose) {
  const std::vector<PosePair> pairs{{pose_at(5, 5), pose_at(0, 0)},
                                    {pose_at(6, 5.3), pose_at(1, 0)},
                                    {pose_at(7, 5.3, 0.4), pose_at(2, 0)}};
  const RelativeError error = relative_error(pairs, 1, {});
  EXPECT_EQ(error.translation.count, 2U);
  EXPECT_NEAR(error.translation.rmse, 0.3 / std::numbers::sqrt2, 1e-12);
  EXPECT_NEAR(error.rotation.max, 0.4, 1e-12);
  EXPECT_NEAR(error.rotation.rmse, 0.4 / std::numbers::sqrt2, 1e-12);
}

TEST(RelativeError, DoesNotChangeIfTheWholeResultMoves) {
  std::vector<PosePair> pairs = square();
  const RelativeError before = relative_error(pairs, 1, {});
  for (PosePair& pair : pairs) pair.result = some_motion()(pair.result);
  const RelativeError after = relative_error(pairs, 1, {});
  EXPECT_NEAR(after.translation.rmse, before.translation.rmse, 1e-12);
  EXPECT_NEAR(after.rotation.rmse, before.rotation.rmse, 1e-12);
}

TEST(RelativeError, HasNoStatisticsForASinglePose) {
  const RelativeError error = relative_error({{pose_at(1, 2), pose_at(3, 4)}}, 1, {});
  EXPECT_EQ(error.translation.count, 0U);
  EXPECT_EQ(error.translation.rmse, 0);
}

TEST(Alignment, HasAnInverse) {
  Alignment motion = some_motion();
  motion.scale = 3;
  const TrajectoryPose pose = pose_at(1, 2, 0.3), back = motion.inverse()(motion(pose));
  EXPECT_TRUE(back.position.isApprox(pose.position, 1e-12));
  EXPECT_TRUE(back.rotation.isApprox(pose.rotation, 1e-12));
}

TEST(AlignPoses, RefusesToEstimateAScaleFromOnePosition) {
  const std::vector<PosePair> pairs{{pose_at(1, 1), pose_at(0, 0)}, {pose_at(1, 1), pose_at(1, 0)}};
  EXPECT_THROW(align_poses(pairs, 2, AlignmentKind::kRigid, true), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
