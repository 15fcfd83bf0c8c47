// SPDX-License-Identifier: BSD-3-Clause
#include "testing/bundle_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "boxplus/manifold/angle.h"

namespace boxplus {
namespace {

constexpr double kEyeHeight = 2, kWallHeight = 12;
/// The distance from the path to the walls on both sides of a street.
constexpr double kWallDistance = 7;
constexpr double kGroundShare = 0.15;  // the fraction of points on the ground

/// The pose of a camera at `place` that looks in the horizontal direction with this heading.
SE3 looking(const Vector3& place, double heading) {
  const double c = std::cos(heading), s = std::sin(heading);
  Matrix<double, 3, 3> axes;  // right, up, and back
  axes << s, 0, -c, -c, 0, -s, 0, 1, 0;
  return SE3(place, SO3(axes).quaternion());
}

/// A place on a path, and the heading of the path there.
struct PathPlace {
  double x, y, heading;

  Vector3 beside(double to_the_left, double height) const {
    return {x - to_the_left * std::sin(heading), y + to_the_left * std::cos(heading), height};
  }
  Vector3 left() const { return {-std::sin(heading), std::cos(heading), 0}; }
};

/// A random point on the ground or on a wall beside a place of a street.
SurfacePoint draw_beside(const PathPlace& place, RandomNumbers& random) {
  if (random.uniform() < kGroundShare)
    return {place.beside(random.uniform(-kWallDistance, kWallDistance), 0), Vector3(0, 0, 1)};
  const double side = random.below(2) == 0 ? 1 : -1, distance = kWallDistance + random.uniform();
  return {place.beside(side * distance, random.uniform(0, kWallHeight)), -side * place.left()};
}

/// A camera that looks ahead sees the walls in a part of the path of about this length.
constexpr double kAhead = BundleScene::kRange - 1.5 * kWallDistance;

class Ring final : public BundleScene {
 public:
  explicit Ring(const BundleOptions& options) {
    constexpr double kSeenOfWall = 2.2 * kDistance;  // the length of the wall in an image
    const double spacing = kSeenOfWall / options.track_length;
    wall_radius_ = std::max(10.0, options.cameras * spacing / (2 * kPi));
    // A few cameras do not close the ring.
    const double turn = std::min(2 * kPi / options.cameras, spacing / wall_radius_);
    for (int k = 0; k < options.cameras; ++k) {
      const double angle = turn * k, radius = wall_radius_ + kDistance;
      const Vector3 place(radius * std::cos(angle), radius * std::sin(angle),
                          kWallHeight / 2 + std::sin(5 * angle));
      cameras.push_back(looking(place, angle + kPi));
    }
  }

  SurfacePoint draw(RandomNumbers& random) const override {
    const double angle = random.uniform(0, 2 * kPi), depth = random.uniform();
    const Vector3 normal(std::cos(angle), std::sin(angle), 0);
    return {(wall_radius_ - depth) * normal + Vector3(0, 0, random.uniform(0, kWallHeight)), normal};
  }

 private:
  static constexpr double kDistance = 12;  // from the cameras to the wall
  double wall_radius_;
};

class Street final : public BundleScene {
 public:
  explicit Street(const BundleOptions& options) {
    const double spacing = kAhead / options.track_length;
    length_ = spacing * options.cameras + kAhead;
    for (int k = 0; k < options.cameras; ++k) {
      const PathPlace place = at(spacing * k);
      cameras.push_back(looking(place.beside(0, kEyeHeight), place.heading));
    }
  }

  SurfacePoint draw(RandomNumbers& random) const override {
    return draw_beside(at(random.uniform(0, length_)), random);
  }

 private:
  /// The street winds around the x axis.
  static PathPlace at(double x) {
    constexpr double kAmplitude = 30, kRate = 0.01;
    return {x, kAmplitude * std::sin(kRate * x), std::atan(kAmplitude * kRate * std::cos(kRate * x))};
  }

  double length_;
};

/// Square blocks. The camera drives through all streets in one direction, then through all streets across,
/// and then through the first ones again.
class City final : public BundleScene {
 public:
  explicit City(const BundleOptions& options) {
    const double spacing = 2 * kAhead / options.track_length;  // it drives through most streets twice
    const double wanted = spacing * options.cameras;
    while (3 * (blocks_ + 2) * (blocks_ + 1) * kLargestBlock <= wanted) ++blocks_;
    block_ = std::clamp(wanted / (3 * (blocks_ + 1) * blocks_), kSmallestBlock, kLargestBlock);
    for (int pass = 0; pass < 3; ++pass) {
      for (int street = 0; street <= blocks_; ++street) {
        streets_.push_back({.across = pass == 1, .back = street % 2 == 1, .number = street});
      }
    }
    const double route = static_cast<double>(streets_.size()) * length();
    const double step = std::min(spacing, route / options.cameras);  // a few cameras see a part of the town
    for (int k = 0; k < options.cameras; ++k) {
      const double s = step * (k + 0.5);
      const auto street = std::min(static_cast<std::size_t>(s / length()), streets_.size() - 1);
      const PathPlace place = at(streets_[street], s - static_cast<double>(street) * length());
      cameras.push_back(looking(place.beside(0, kEyeHeight), place.heading));
    }
  }

  SurfacePoint draw(RandomNumbers& random) const override {
    const int street = random.below(static_cast<int>(streets_.size()) * 2 / 3);  // the last third is again
    return draw_beside(at(streets_[static_cast<std::size_t>(street)], random.uniform(0, length())), random);
  }

 private:
  static constexpr double kSmallestBlock = 40, kLargestBlock = 60;
  struct Drive {
    bool across, back;
    int number;
  };

  double length() const { return blocks_ * block_; }

  PathPlace at(const Drive& drive, double s) const {
    const double along = drive.back ? length() - s : s, beside = block_ * drive.number;
    const double heading = (drive.across ? kPi / 2 : 0) + (drive.back ? kPi : 0);
    return drive.across ? PathPlace{beside, along, heading} : PathPlace{along, beside, heading};
  }

  int blocks_ = 1;
  double block_;  // the length of the side of a block
  std::vector<Drive> streets_;
};

}  // namespace

std::unique_ptr<BundleScene> make_bundle_scene(BundleWorld world, const BundleOptions& options) {
  switch (world) {
    case BundleWorld::kRing:
      return std::make_unique<Ring>(options);
    case BundleWorld::kStreet:
      return std::make_unique<Street>(options);
    default:
      return std::make_unique<City>(options);
  }
}

}  // namespace boxplus
