// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "guess/scene.h"

namespace boxplus {
namespace {

using namespace test;

template <class World>
class OdometryGuess : public ::testing::Test {};
TYPED_TEST_SUITE(OdometryGuess, Worlds);

TYPED_TEST(OdometryGuess, FollowsConsecutiveIdsAndBridgesGaps) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0, 10), b = scene.add_pose(1, 11), c = scene.add_pose(2, 20),
             d = scene.add_pose(3, 21);
  scene.fix(a);
  scene.join(a, b);
  scene.join(b, d);  // the correct edge across the gap between the ids 11 and 20
  scene.join(c, d);
  // A wrong edge across the same gap. The chain reaches b, so b must not depend on this edge.
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1e6, a, d);
  EXPECT_TRUE(scene.apply(0).made);
  EXPECT_LT(scene.error(b), 1e-9);
  scene.graph.set_enabled(scene.graph.all_edges().back(), false);
  scene.expect_truth_from(0);
}

TYPED_TEST(OdometryGuess, DoesNotUseLoopClosures) {
  Scene<TypeParam> scene;
  const auto poses = add_loop(scene);
  scene.fix(poses[0]);
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1e6, poses[0], poses[4]);
  scene.expect_truth_from(0);
}

}  // namespace
}  // namespace boxplus
