// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "testing/bundle_scene.h"
#include "testing/town_route.h"

namespace boxplus {
namespace {

TEST(TownScene, BuildingsHideWhatIsBehindThem) {
  const auto scene = make_town_scene(false);
  const Vector3 in_street(20, 0, 2);
  EXPECT_FALSE(scene->is_hidden({60, 7.9, 5}, in_street)) << "a facade of the same street";
  EXPECT_FALSE(scene->is_hidden({60, -7.9, 0}, in_street));
  EXPECT_TRUE(scene->is_hidden({20, 79, 2}, in_street)) << "the next street, behind a block";
  EXPECT_TRUE(scene->is_hidden({1, 30, 2}, in_street)) << "around the corner";
  EXPECT_FALSE(scene->is_hidden({1, 30, 2}, {4, 0, 2})) << "from the crossing";
  EXPECT_FALSE(scene->is_hidden({20, 40, 80}, in_street)) << "above the roofs";
}

TEST(TownScene, RaysHitTheGroundAndFacadesWithinHalfAMeter) {
  const auto scene = make_town_scene(false);
  RandomNumbers random(1);
  const Vector3 camera(20, 0, 2);
  int hits = 0;
  for (int k = 0; k < 200; ++k) {
    const auto left = scene->hit(camera, Vector3(1, 1, 0).normalized(), random);
    ASSERT_TRUE(left);
    EXPECT_GT(left->position[1], Town::kHalfStreet - 0.5);
    EXPECT_LE(left->position[1], Town::kHalfStreet);
    const auto down = scene->hit(camera, Vector3(2, 0, -1).normalized(), random);
    ASSERT_TRUE(down);
    EXPECT_GE(down->position[2], 0);
    EXPECT_LT(down->position[2], 0.5);
    EXPECT_FALSE(scene->hit(camera, Vector3(1, 0, 0), random)) << "the end of the street is too far away";
    EXPECT_FALSE(scene->hit(camera, Vector3(1, 0, 1).normalized(), random)) << "the sky";
    hits += scene->hit(camera, Vector3(40, 8, 0).normalized(), random).has_value();
  }
  EXPECT_GT(hits, 20) << "some points are recognized from 40 m";
  EXPECT_LT(hits, 180);
}

TEST(TownScene, MoreOverlapPlacesTheCamerasCloser) {
  const auto scene = make_town_scene(true);
  const auto first_step = [&](double overlap) {
    scene->place(10, overlap, RandomNumbers(1));
    return (scene->poses()[1].translation() - scene->poses()[0].translation()).norm();
  };
  EXPECT_NEAR(first_step(0), 5, 1);
  EXPECT_NEAR(first_step(0.5), 5, 1);
  EXPECT_LT(first_step(1), 1.5);
  scene->place(10, 0, RandomNumbers(1));
  EXPECT_NEAR(scene->chance(), 0.05, 1e-12);
  scene->place(10, 0.75, RandomNumbers(1));
  EXPECT_EQ(scene->chance(), 1);
}

}  // namespace
}  // namespace boxplus
