// SPDX-License-Identifier: BSD-3-Clause
#include "testing/survey.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// A wall at x = 10, which hides nothing. It has a point only for cameras that look along x.
class Wall final : public BundleScene {
 public:
  /// The cameras are on the y-axis in steps of `step` meters. The first `averted` of them look along −x.
  Wall(double step, int averted) : step_(step), averted_(averted) {}

  void place(int cameras, double /*overlap*/, RandomNumbers random) override {
    for (int k = 0; k < cameras; ++k)
      poses_.push_back(upright_pose({0, step_ * k, 2}, {k < averted_ ? -1.0 : 1.0, 0, 0}, 0, random));
  }
  std::optional<SurfacePoint> hit(const Vector3& camera, const Vector3& direction,
                                  RandomNumbers& /*random*/) const override {
    if (direction[0] <= 0) return std::nullopt;
    const Vector3 point = camera + 10 / direction[0] * direction;
    return SurfacePoint{.position = point,
                        .view = direction,
                        .min_cosine = 0.5,
                        .max_distance = 20,
                        .search_center = camera.head<2>(),
                        .search_radius = 5};
  }
  bool is_hidden(const Vector3& /*point*/, const Vector3& /*camera*/) const override { return false; }

 private:
  double step_;
  int averted_;
};

const std::array kShared{BalCamera(600, 0, 0)};

TEST(Survey, AFinderThatSeesNoPointsPassesItsTurn) {
  Wall wall(1, 1);
  wall.place(4, 0, RandomNumbers(1));
  const Survey survey(wall, kShared);
  RandomNumbers random(1);
  Track track;
  for (const int finder : {0, 1, 3}) {
    survey.find(finder, random, track);
    ASSERT_GE(track.observations.size(), 2u);
    EXPECT_TRUE(std::none_of(track.observations.begin(), track.observations.end(),
                             [](const Observation& seen) { return seen.camera == 0; }));
    EXPECT_NEAR(track.point[0], 10, 1e-12);
  }
  EXPECT_GT(survey.mean_length(300, random), 2.5);
}

void expect_nothing_found(Wall& wall) {
  wall.place(3, 0, RandomNumbers(1));
  RandomNumbers random(1);
  Track track;
  EXPECT_THROW(Survey(wall, kShared).find(1, random, track), InvalidArgument);
}

TEST(Survey, ThrowsIfOnlyOneCameraSeesPoints) {
  Wall wall(1, 2);
  expect_nothing_found(wall);
}

TEST(Survey, ThrowsIfAllCamerasSeePointsFromTheSameDirection) {
  Wall wall(0.1, 0);
  expect_nothing_found(wall);
}

}  // namespace
}  // namespace boxplus
