// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "testing/bundle_scene.h"

namespace boxplus {
namespace {

TEST(RingScene, CamerasLookAtTheObject) {
  const auto scene = make_ring_scene();
  scene->place(50, 0.5, RandomNumbers(1));
  ASSERT_EQ(scene->poses().size(), 50u);
  for (const SE3& pose : scene->poses()) {
    const Vector3 center = pose.inverse_times(Vector3(0, 0, 0));
    EXPECT_LT(center.head<2>().norm(), -0.2 * center[2]);
    const Vector3 up = pose.inverse_times(Vector3(pose.translation() + Vector3(0, 0, 1)));
    EXPECT_GT(up[1], 0.8) << "y points up in the image";
  }
}

TEST(RingScene, RaysHitTheFrontOfTheObjectOrNothing) {
  const auto scene = make_ring_scene();
  RandomNumbers random(1);
  const Vector3 camera(10, 0, 0);
  const auto front = scene->hit(camera, Vector3(-1, 0, 0), random);
  ASSERT_TRUE(front);
  EXPECT_NEAR(front->position[0], 4, 0.33);
  EXPECT_FALSE(scene->is_hidden(front->position, camera));
  EXPECT_TRUE(scene->is_hidden(front->position, {-10, 0, 0}));
  EXPECT_FALSE(scene->hit(camera, Vector3(1, 0, 0), random)) << "the object is behind";
  EXPECT_FALSE(scene->hit(camera, Vector3(0, 1, 0), random));
}

}  // namespace
}  // namespace boxplus
