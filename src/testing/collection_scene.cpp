// SPDX-License-Identifier: BSD-3-Clause
// Photos that many people took on a square: of a few sights, some of which are far more popular than others.
#include <algorithm>
#include <cmath>

#include "testing/bundle_scene.h"

namespace boxplus {
namespace {

/// The sights are parts of the facades around the square, which are a vertical cylinder. So no surface hides
/// another. The k-th sight attracts photos in proportion to k^−kSkew (Zipf's law).
class CollectionScene final : public BundleScene {
 public:
  void place(int cameras, double overlap, RandomNumbers random) override {
    poses_.clear();
    poses_.reserve(static_cast<std::size_t>(cameras));
    const int sights = std::clamp(cameras / kPhotosPerSight, 1, kMostSights);
    for (int k = 0; k < cameras; ++k) {
      // The first two photos show the most popular sight, so that two cameras share points.
      const double sight = k < 2 ? 0 : kGoldenAngle * draw_sight(sights, random);
      const double angle = sight + kSightWidth * random.normal();
      const Vector3 target(kRadius * std::cos(angle), kRadius * std::sin(angle), random.uniform(2, 6));
      const double distance = log_uniform(kNearest, kFarthest, random);
      const double aside = angle + kPi + random.uniform(-kMostAside, kMostAside);
      const Vector3 position(target[0] + distance * std::cos(aside), target[1] + distance * std::sin(aside),
                             random.uniform(1.5, 2.5));
      poses_.push_back(upright_pose(position, target - position, 0.1, random));
    }
    least_chance_ = std::pow(1.0 / cameras, 1 - overlap);
    tail_ = 2 - overlap;
  }

  std::optional<SurfacePoint> hit(const Vector3& camera, const Vector3& direction,
                                  RandomNumbers& random) const override {
    const double across = direction.head<2>().squaredNorm(),
                 toward = camera.head<2>().dot(direction.head<2>());
    const double inside = kRadius * kRadius - camera.head<2>().squaredNorm();
    if (across == 0 || inside <= 0) return std::nullopt;
    const double range = (std::sqrt(toward * toward + across * inside) - toward) / across;
    const Vector3 point = camera + (range - random.uniform(0, kRelief)) * direction;
    if (point[2] < 0 || point[2] > kRoof) return std::nullopt;
    const double distance = (point - camera).norm();
    // Pareto's law: of all points, the fraction c^−tail_ is seen c times as often as the least visible ones.
    const double visible = std::pow(1 - random.uniform(), -1 / tail_);
    return SurfacePoint{.position = point,
                        .view = direction,
                        .min_cosine = std::cos(log_uniform(20 * kPi / 180, 80 * kPi / 180, random)),
                        .max_distance = distance * log_uniform(1, 4, random),
                        .search_center = Vector2(0, 0),
                        .search_radius = kRadius,
                        .chance = std::min(1.0, least_chance_ * visible)};
  }

  bool is_hidden(const Vector3& /*point*/, const Vector3& /*camera*/) const override { return false; }

 private:
  static constexpr double kRadius = 16, kRoof = 12, kRelief = 1;  // of the facades, in meters
  static constexpr int kPhotosPerSight = 8, kMostSights = 12;
  static constexpr double kSkew = 1.2;
  static constexpr double kGoldenAngle =
      2.399963229728653;                       // neighbors in popularity are not neighbors in space
  static constexpr double kSightWidth = 0.15;  // radians, seen from the middle of the square
  static constexpr double kNearest = 5, kFarthest = 23, kMostAside = 40 * kPi / 180;

  /// The rank of a sight, from 0 for the most popular one.
  static int draw_sight(int sights, RandomNumbers& random) {
    double sum = 0;
    for (int k = 1; k <= sights; ++k) sum += std::pow(k, -kSkew);
    double left = random.uniform() * sum;
    for (int k = 1; k < sights; ++k) {
      left -= std::pow(k, -kSkew);
      if (left < 0) return k - 1;
    }
    return sights - 1;
  }

  double least_chance_ = 1;  // of the points that are recognized least often
  double tail_ = 2;
};

}  // namespace

std::unique_ptr<BundleScene> make_collection_scene() {
  return std::make_unique<CollectionScene>();
}

}  // namespace boxplus
