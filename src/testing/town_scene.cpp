// SPDX-License-Identifier: BSD-3-Clause
// A car that drives through a town, and sees the ground and the facades of the blocks.
#include <algorithm>
#include <cmath>
#include <limits>

#include "testing/bundle_scene.h"
#include "testing/town_route.h"

namespace boxplus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoof = 15;

/// The parameter t ≥ 0 at which the ray origin + t · direction enters the building of a block, or infinity.
double entry(int column, int row, const Vector3& origin, const Vector3& direction) {
  const double low[] = {column * Town::kBlock + Town::kHalfStreet, row * Town::kBlock + Town::kHalfStreet, 0};
  const double width = Town::kBlock - 2 * Town::kHalfStreet;
  const double high[] = {low[0] + width, low[1] + width, kRoof};
  double enter = 0, leave = kInfinity;
  for (int i = 0; i < 3; ++i) {
    if (direction[i] == 0) {
      if (origin[i] <= low[i] || origin[i] >= high[i]) return kInfinity;
      continue;
    }
    const double a = (low[i] - origin[i]) / direction[i], b = (high[i] - origin[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : kInfinity;
}

int block_of(double coordinate) {
  return static_cast<int>(std::floor(coordinate / Town::kBlock));
}

/// The least t in [0, 1] at which origin + t · direction is in a building, or infinity.
double first_entry(const Vector3& origin, const Vector3& direction) {
  const Vector3 end = origin + direction;
  double first = kInfinity;
  for (int row = block_of(std::min(origin[1], end[1])); row <= block_of(std::max(origin[1], end[1])); ++row) {
    for (int column = block_of(std::min(origin[0], end[0])); column <= block_of(std::max(origin[0], end[0]));
         ++column) {
      first = std::min(first, entry(column, row, origin, direction));
    }
  }
  return first <= 1 ? first : kInfinity;
}

class TownScene final : public BundleScene {
 public:
  explicit TownScene(bool returns) : returns_(returns) {}

  void place(int cameras, double overlap, RandomNumbers random) override {
    constexpr double kMaxSpacing = 5, kHeight = 2, kMinChance = 0.05;
    // A few cameras are not so close that all of them see a point from almost the same direction.
    const double min_spacing = std::clamp(10.0 / cameras, 0.1, kMaxSpacing);
    // Up to half of the range, the cameras observe more of the points that they see; then, they are closer.
    chance_ = std::pow(kMinChance, std::max(0.0, 1 - 2 * overlap));
    const double spacing = kMaxSpacing * std::pow(min_spacing / kMaxSpacing, std::max(0.0, 2 * overlap - 1));
    const TownRoute route(cameras * spacing, returns_, random);
    poses_.clear();
    poses_.reserve(static_cast<std::size_t>(cameras));
    for (int k = 0; k < cameras; ++k) {
      const TownRoute::Place place = route.at(k * spacing);
      const Vector3 forward(std::cos(place.heading), std::sin(place.heading), 0);
      const double left = 0.3 * random.normal(), up = kHeight + random.uniform(-0.1, 0.1);
      const Vector3 position(place.position[0] - left * forward[1], place.position[1] + left * forward[0],
                             up);
      poses_.push_back(upright_pose(position, forward, 0.02, random));
    }
  }

  std::optional<SurfacePoint> hit(const Vector3& camera, const Vector3& direction,
                                  RandomNumbers& random) const override {
    constexpr double kMinRange = 15, kMaxRange = 60, kRelief = 0.5;  // meters
    constexpr double kMinCosine = 0.5;
    const double range = log_uniform(kMinRange, kMaxRange, random);
    const double ground = direction[2] < 0 ? -camera[2] / direction[2] : kInfinity;
    const double distance = std::min(ground, range * first_entry(camera, range * direction));
    if (!(distance <= range)) return std::nullopt;
    const Vector3 point = camera + (distance - random.uniform(0, kRelief)) * direction;
    return SurfacePoint{.position = point,
                        .view = direction,
                        .min_cosine = kMinCosine,
                        .max_distance = range,
                        .search_center = point.head<2>(),
                        .search_radius = range};
  }

  bool is_hidden(const Vector3& point, const Vector3& camera) const override {
    return first_entry(camera, point - camera) <= 1;
  }

  double chance() const override { return chance_; }

 private:
  bool returns_;
  double chance_ = 1;
};

}  // namespace

std::unique_ptr<BundleScene> make_town_scene(bool returns) {
  return std::make_unique<TownScene>(returns);
}

}  // namespace boxplus
