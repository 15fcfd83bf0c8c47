// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/calibrate_hand_eye.h"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "boxplus/base/error.h"
#include "types/slam3d/sensor_world.h"

namespace boxplus {
namespace {

const SE3 kMount = pose(0.1, -0.2, 0.3, 0.5, -1, 2);

HandEye<SE3> exact(const SE3& hand) {
  return {hand, kMount.inverse() * hand * kMount};
}

TEST(CalibrateHandEye, IsExactForExactMotions) {
  RandomNumbers random(1);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<HandEye<SE3>> motions;
    for (int k = 0; k < 2 + trial % 5; ++k) motions.push_back(exact(random_pose(random, 1.5)));
    const auto mount = calibrate_hand_eye(motions);
    ASSERT_TRUE(mount.has_value());
    EXPECT_LT((mount->translation() - kMount.translation()).norm(), 1e-9);
    EXPECT_LT((mount->so3().inverse() * kMount.so3()).rotation_vector().norm(), 1e-9);
  }
}

TEST(CalibrateHandEye, IsNearTheTruthForNoisyMotions) {
  RandomNumbers random(2);
  std::vector<HandEye<SE3>> motions;
  for (int k = 0; k < 50; ++k) {
    const HandEye<SE3> motion = exact(random_pose(random, 1.5));
    motions.emplace_back(motion.hand * random_pose(random, 0.02), motion.eye * random_pose(random, 0.02));
  }
  const auto mount = calibrate_hand_eye(motions);
  ASSERT_TRUE(mount.has_value());
  EXPECT_LT((mount->translation() - kMount.translation()).norm(), 0.03);
  EXPECT_LT((mount->so3().inverse() * kMount.so3()).rotation_vector().norm(), 0.03);
}

TEST(CalibrateHandEye, ReturnsNothingIfTheMotionsDoNotDetermineTheMount) {
  EXPECT_FALSE(calibrate_hand_eye({}).has_value());
  const std::vector<HandEye<SE3>> one{exact(pose(1, 2, 3, 0.1, 0.2, 0.3))};
  EXPECT_FALSE(calibrate_hand_eye(one).has_value());
  const std::vector<HandEye<SE3>> planar{exact(pose(1, 2, 0, 0, 0, 0.5)), exact(pose(-1, 0, 0, 0, 0, -0.9)),
                                         exact(pose(0.3, 1, 0, 0, 0, 1.2))};
  EXPECT_FALSE(calibrate_hand_eye(planar).has_value());
  const std::vector<HandEye<SE3>> straight{exact(pose(1, 2, 0, 0, 0, 0)), exact(pose(0, 0, 1, 0, 0, 0))};
  EXPECT_FALSE(calibrate_hand_eye(straight).has_value());
}

TEST(CalibrateHandEye, RejectsNumbersThatAreNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<HandEye<SE3>> motions{exact(SE3()), {SE3(), SE3(Vector3(nan, 0, 0), SO3())}};
  EXPECT_THROW(std::ignore = calibrate_hand_eye(motions), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
