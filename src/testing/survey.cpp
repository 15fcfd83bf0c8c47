// SPDX-License-Identifier: BSD-3-Clause
#include "testing/survey.h"

#include <algorithm>
#include <cmath>

#include "boxplus/base/error.h"
#include "boxplus/manifold/angle.h"
#include "testing/random_selection.h"

namespace boxplus {
namespace {

constexpr double kCellWidth = 20;  // meters

/// Two cameras see a point from directions that differ by at least this angle, as in programs that
/// triangulate points. Otherwise, the distance of the point would be almost unknown.
constexpr double kMinParallax = 3 * kPi / 180;

}  // namespace

Survey::Survey(const BundleScene& scene, std::span<const BalCamera> intrinsics)
    : scene_(scene), intrinsics_(intrinsics), cells_(kCellWidth) {
  int camera = 0;
  for (const SE3& pose : scene.poses()) cells_.add(pose.translation().head<2>(), camera++);
}

void Survey::find(int finder, RandomNumbers& random, Track& track) const {
  constexpr int kFinders = 100, kTrials = 200;
  for (int k = 0; k < kFinders; ++k) {
    for (int trial = 0; trial < kTrials; ++trial) {
      if (try_to_find(finder, random, track)) return;
    }
    finder = random.below(static_cast<int>(scene_.poses().size()));
  }
  throw InvalidArgument(
      "simulate_bundle: expected cameras that see common points, got cameras that see none");
}

double Survey::mean_length(int tracks, RandomNumbers random) const {
  const auto cameras = static_cast<std::int64_t>(scene_.poses().size());
  Track track;
  double sum = 0;
  for (int k = 0; k < tracks; ++k) {
    find(static_cast<int>(k * cameras / tracks), random, track);
    sum += static_cast<double>(track.observations.size());
  }
  return sum / tracks;
}

bool Survey::try_to_find(int finder, RandomNumbers& random, Track& track) const {
  constexpr double kHalfWidth = 0.9, kHalfHeight = 0.65;  // about the image, at distance 1
  const SE3& pose = scene_.poses()[finder];
  const double x = random.uniform(-kHalfWidth, kHalfWidth), y = random.uniform(-kHalfHeight, kHalfHeight);
  const Vector3 direction = (pose.so3() * Vector3(x, y, -1)).normalized();
  const std::optional<SurfacePoint> point = scene_.hit(pose.translation(), direction, random);
  if (!point) return false;
  const std::optional<Vector2> pixel = pixel_of(finder, *point);
  if (!pixel) return false;
  track.point = point->position;
  track.observations = {{finder, *pixel}};
  RandomSelection selection(scene_.chance() * point->chance, random);
  cells_.around(point->search_center, point->search_radius, [&](int camera) {
    if (camera == finder || !selection.takes_next()) return;
    if (const auto seen = pixel_of(camera, *point)) track.observations.push_back({camera, *seen});
  });
  std::sort(track.observations.begin(), track.observations.end(),
            [](const Observation& a, const Observation& b) { return a.camera < b.camera; });
  return has_parallax(*point, track);
}

bool Survey::has_parallax(const SurfacePoint& point, const Track& track) const {
  static const double max_cosine = std::cos(kMinParallax);
  return std::any_of(track.observations.begin(), track.observations.end(), [&](const Observation& seen) {
    const SE3& pose = scene_.poses()[seen.camera];
    const Vector3 view = point.position - pose.translation();
    return view.dot(point.view) <= max_cosine * view.norm();
  });
}

/// The pixel at which a camera recognizes a point, if it does.
std::optional<Vector2> Survey::pixel_of(int camera, const SurfacePoint& point) const {
  constexpr double kMinDepth = 2;
  const SE3& pose = scene_.poses()[camera];
  const Vector3 center = pose.translation(), view = point.position - center;
  const double distance = view.norm();
  if (distance > point.max_distance || view.dot(point.view) < point.min_cosine * distance)
    return std::nullopt;
  const Vector3 inside = pose.inverse_times(point.position);
  if (-inside[2] < kMinDepth) return std::nullopt;
  const auto own = intrinsics_.size() == 1 ? std::size_t{0} : static_cast<std::size_t>(camera);
  const Vector2 pixel = intrinsics_[own].project(inside);
  if (!BundleImage::contains(pixel) || scene_.is_hidden(point.position, center)) return std::nullopt;
  return pixel;
}

}  // namespace boxplus
