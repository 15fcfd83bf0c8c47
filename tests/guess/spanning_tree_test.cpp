// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "guess/scene.h"

namespace boxplus {
namespace {

using namespace test;

template <class World>
class SpanningTreeGuess : public ::testing::Test {};
TYPED_TEST_SUITE(SpanningTreeGuess, Worlds);

TYPED_TEST(SpanningTreeGuess, PrefersTwoAccurateEdgesToOneInaccurateEdge) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0), b = scene.add_pose(1), c = scene.add_pose(2);
  scene.fix(a);
  scene.join(a, b, 10.0);
  scene.join(b, c, 10.0);
  scene.graph.add_edge(Between<TypeParam>{TypeParam::motion(55)}, 1.0, a, c);
  scene.expect_truth_from(1);
}

TYPED_TEST(SpanningTreeGuess, DoesNotMoveAPoseThatIsConnectedThroughLandmarksOnly) {
  Scene<TypeParam> scene;
  const auto a = scene.add_pose(0), b = scene.add_pose(1);
  const auto p = scene.add_point(2), q = scene.add_point(3);
  scene.fix(a);
  scene.see(a, p);
  scene.see(b, p);
  scene.see(b, q);
  scene.graph.set_estimate(b, Pose<TypeParam>{scene.truth(b)});
  scene.expect_truth_from(1);
}

}  // namespace
}  // namespace boxplus
