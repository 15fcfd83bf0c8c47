// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "testing/bundle_scene.h"

namespace boxplus {
namespace {

constexpr double kRadius = 16;

std::unique_ptr<BundleScene> square_with(int photos) {
  auto scene = make_collection_scene();
  scene->place(photos, 0.5, RandomNumbers(1));
  return scene;
}

TEST(CollectionScene, PhotosAreTakenOnTheSquare) {
  const auto scene = square_with(500);
  ASSERT_EQ(scene->poses().size(), 500u);
  for (const SE3& pose : scene->poses()) {
    EXPECT_LT(pose.translation().head<2>().norm(), kRadius);
    const Vector3 up = pose.inverse_times(Vector3(pose.translation() + Vector3(0, 0, 1)));
    EXPECT_GT(up[1], 0.6) << "y points up in the image";
  }
}

TEST(CollectionScene, SomeSightsAreFarMorePopularThanOthers) {
  const auto scene = square_with(2000);
  constexpr int kDirections = 12;
  std::array<int, kDirections> photos{};
  for (const SE3& pose : scene->poses()) {
    const Vector3 forward = pose * Vector3(0, 0, -1) - pose.translation();
    const double turn = std::atan2(forward[1], forward[0]) / (2 * kPi) + 0.5;
    ++photos[std::min<std::size_t>(static_cast<std::size_t>(kDirections * turn), kDirections - 1)];
  }
  std::sort(photos.begin(), photos.end());
  EXPECT_GT(photos.back(), 4 * photos.front());
}

TEST(CollectionScene, RaysHitTheFacadesOrNothing) {
  const auto scene = square_with(100);
  RandomNumbers random(1);
  const Vector3 camera(4, 0, 2);
  const auto facade = scene->hit(camera, Vector3(1, 0, 0), random);
  ASSERT_TRUE(facade);
  EXPECT_NEAR(facade->position[0], kRadius - 0.5, 0.5);
  EXPECT_EQ(facade->position[2], 2);
  EXPECT_FALSE(scene->hit(camera, Vector3(0.1, 0, 0.995), random)) << "above the roofs";
  EXPECT_FALSE(scene->hit(camera, Vector3(0, 0, 1), random)) << "the sky";
}

TEST(CollectionScene, FewPointsAreSeenManyTimesAsOftenAsMost) {
  const auto scene = square_with(1000);
  RandomNumbers random(1);
  std::vector<double> chances;
  for (int k = 0; k < 5000; ++k) chances.push_back(scene->hit({4, 0, 2}, Vector3(1, 0, 0), random)->chance);
  std::sort(chances.begin(), chances.end());
  const double least = chances.front();
  EXPECT_LT(chances[2500], 2 * least);
  EXPECT_GT(chances[4950], 20 * least);
  EXPECT_LE(chances.back(), 1);
}

}  // namespace
}  // namespace boxplus
