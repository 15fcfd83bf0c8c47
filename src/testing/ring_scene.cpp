// SPDX-License-Identifier: BSD-3-Clause
// Cameras on a ring around a sphere with a rough surface.
#include <algorithm>
#include <cmath>

#include "testing/bundle_scene.h"

namespace boxplus {
namespace {

class RingScene final : public BundleScene {
 public:
  void place(int cameras, double overlap, RandomNumbers random) override {
    constexpr double kWidestStep =
        20 * kPi / 180;  // between neighbors; a few cameras are on a part of the ring
    const double step = std::min(2 * kPi / cameras, kWidestStep);
    poses_.clear();
    poses_.reserve(static_cast<std::size_t>(cameras));
    for (int k = 0; k < cameras; ++k) {
      const double radius = kRing + random.uniform(-kJitter, kJitter), height = random.uniform(-1, 3);
      const Vector3 position(radius * std::cos(k * step), radius * std::sin(k * step), height);
      poses_.push_back(upright_pose(position, -position, 0.03, random));
    }
    chance_ = std::pow(2.0 / cameras, 1 - overlap);
  }

  std::optional<SurfacePoint> hit(const Vector3& camera, const Vector3& direction,
                                  RandomNumbers& random) const override {
    const double along = -camera.dot(direction);  // to the point of the ray that is nearest to the center
    const double squared_half_chord = kSphere * kSphere - camera.squaredNorm() + along * along;
    if (along <= 0 || squared_half_chord <= 0) return std::nullopt;
    const Vector3 on_sphere = camera + (along - std::sqrt(squared_half_chord)) * direction;
    const Vector3 point = (1 + random.uniform(-0.08, 0.08)) * on_sphere;
    if (is_hidden(point, camera)) return std::nullopt;
    const double angle = log_uniform(kMinAngle, kMaxAngle, random);
    // If the view turns by an angle, the camera moves around the center by about the same angle.
    return SurfacePoint{.position = point,
                        .view = (point - camera).normalized(),
                        .min_cosine = std::cos(angle),
                        .max_distance = 2 * kRing,
                        .search_center = camera.head<2>(),
                        .search_radius = 2 * kRing * std::sin(angle / 2) + 3 * kJitter};
  }

  bool is_hidden(const Vector3& point, const Vector3& camera) const override {
    constexpr double kFlattest = 0.2;  // the sine of the least angle between a surface and a view of it
    const Vector3 back = camera - point;
    return back.dot(point) < kFlattest * back.norm() * point.norm();
  }

  double chance() const override { return chance_; }

 private:
  static constexpr double kSphere = 4, kRing = 10, kJitter = 1;  // radii in meters
  static constexpr double kMinAngle = 15 * kPi / 180, kMaxAngle = 60 * kPi / 180;

  double chance_ = 1;
};

}  // namespace

std::unique_ptr<BundleScene> make_ring_scene() {
  return std::make_unique<RingScene>();
}

}  // namespace boxplus
