// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_bundle.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <unordered_map>

#include "boxplus/base/error.h"
#include "boxplus/graph/make_room.h"
#include "testing/bundle_scene.h"

namespace boxplus {
namespace {

using Camera = BundleSimulation::Camera;

/// The pixels of an image have at most these distances from its center.
constexpr double kHalfWidth = 1000, kHalfHeight = 750;
/// A camera does not see a point on a wall that it sees at a smaller angle than acos of this value.
constexpr double kLeastCosine = 0.1;
/// Two cameras see a point from directions that differ by at least this angle, as in programs that
/// triangulate points. Otherwise, its distance would be almost unknown.
constexpr double kLeastParallax = 3 * kPi / 180;
constexpr double kNearest = 1;  // the smallest distance from which a camera sees a point

BalCamera draw_lens(RandomNumbers& random) {
  const double focal_length = random.uniform(980, 1020), k1 = random.uniform(-0.025, -0.015);
  return BalCamera(focal_length, k1, 0.002);
}

/// Finds the cameras near a place.
class CameraFinder {
 public:
  explicit CameraFinder(const std::vector<SE3>& cameras) {
    for (std::uint32_t k = 0; k < cameras.size(); ++k) {
      const Vector3 place = cameras[k].translation();
      cells_[key(cell(place[0]), cell(place[1]))].push_back(k);
    }
  }

  /// Calls f for all cameras within BundleScene::kRange, and for some others, in a fixed order.
  template <class F>
  void for_each_near(const Vector3& place, F&& f) const {
    for (std::int64_t x = -1; x <= 1; ++x) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        const auto found = cells_.find(key(cell(place[0]) + x, cell(place[1]) + y));
        if (found == cells_.end()) continue;
        for (const std::uint32_t camera : found->second) f(camera);
      }
    }
  }

 private:
  static std::int64_t cell(double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / BundleScene::kRange));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y) {
    return static_cast<std::uint64_t>(x) << 32 ^ (static_cast<std::uint64_t>(y) & 0xFFFFFFFFu);
  }

  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

class BundleSimulator {
 public:
  BundleSimulator(BundleWorld world, const BundleOptions& options)
      : options_(options),
        random_(options.seed),
        scene_(make_bundle_scene(world, options)),
        finder_(scene_->cameras) {}

  BundleSimulation simulate() {
    add_cameras();
    for (int k = 0; k < options_.points; ++k) add_point();
    return std::move(result_);
  }

 private:
  struct View {
    std::uint32_t camera;
    Vector2 pixel;
  };

  void add_cameras() {
    for (const SE3& pose : scene_->cameras) {
      const Camera& truth = result_.true_cameras.emplace_back(pose, draw_lens(random_));
      Vector<double, 9> shift;
      shift << noise<3>(0.1), noise<3>(kHalfRotation), noise<1>(5), 0, 0;
      result_.cameras.push_back(result_.graph.add_vertex(Manifold<Camera>::oplus(truth, shift.data())));
    }
    result_.true_points.reserve(static_cast<std::size_t>(options_.points));
    result_.points.reserve(static_cast<std::size_t>(options_.points));
  }

  /// Adds a point that at least two cameras see from directions that determine its distance.
  void add_point() {
    constexpr int kMostTries = 100'000;
    SurfacePoint point;
    int tries = 0;
    do {
      if (++tries > kMostTries)
        throw InvalidArgument(
            "simulate_bundle: expected cameras that see common places, got cameras that are too far apart; "
            "increase track_length");
      point = scene_->draw(random_);
      find_views(point);
    } while (!has_parallax(point.place));
    const auto vertex = result_.graph.add_vertex(Vector3(point.place + noise<3>(0.1)));
    result_.graph.set_eliminated(vertex, true);
    result_.points.push_back(vertex);
    result_.true_points.push_back(point.place);
    for (const View& view : views_) add_observation(view, vertex);
  }

  void find_views(const SurfacePoint& point) {
    views_.clear();
    finder_.for_each_near(point.place, [&](std::uint32_t camera) {
      const Vector3 to_camera = scene_->cameras[camera].translation() - point.place;
      const double distance = to_camera.norm();
      if (distance > BundleScene::kRange || distance < kNearest) return;
      if (to_camera.dot(point.normal) < kLeastCosine * distance) return;
      const Vector3 local = scene_->cameras[camera].inverse_times(point.place);
      if (local[2] > -kNearest) return;  // behind the camera, or too close
      const Vector2 pixel = result_.true_cameras[camera].get<1>().project(local);
      if (std::abs(pixel[0]) > kHalfWidth || std::abs(pixel[1]) > kHalfHeight) return;
      views_.push_back({camera, pixel});
    });
  }

  /// Whether two of the cameras that see the place see it from directions at kLeastParallax or more.
  bool has_parallax(const Vector3& place) const {
    const auto direction = [&](const View& view) {
      return (scene_->cameras[view.camera].translation() - place).normalized();
    };
    static const double most = std::cos(kLeastParallax);
    for (std::size_t a = 1; a < views_.size(); ++a) {
      if (direction(views_[a]).dot(direction(views_[0])) <= most) return true;
    }
    return false;
  }

  void add_observation(const View& view, VertexHandle<Vector3> point) {
    const bool wrong = random_.uniform() < options_.outliers;
    const Vector2 near = view.pixel + noise<2>(1);
    const double x = random_.uniform(-kHalfWidth, kHalfWidth), y = random_.uniform(-kHalfHeight, kHalfHeight);
    const Vector2 pixel = wrong ? Vector2(x, y) : near;
    detail::make_room(result_.edges);
    result_.edges.push_back(
        result_.graph.add_edge(Reprojection<BalCamera>(pixel), result_.cameras[view.camera], point));
    result_.kinds.push_back(wrong ? EdgeKind::kOutlier : EdgeKind::kRecognition);
  }

  template <int N>
  Vector<double, N> noise(double deviation) {
    Vector<double, N> result;
    for (double& value : result) value = options_.noise * deviation * random_.normal();
    return result;
  }

  /// The ⊞ of SE3 takes half of a rotation vector, for small rotations: 0.3°.
  static constexpr double kHalfRotation = 0.3 * kPi / 180 / 2;

  const BundleOptions& options_;
  RandomNumbers random_;
  std::unique_ptr<BundleScene> scene_;
  CameraFinder finder_;
  BundleSimulation result_;
  std::vector<View> views_;  // of one point
};

void check(const BundleOptions& options) {
  const auto require = [](bool holds, const char* expected, double got) {
    if (!holds) throw InvalidArgument(fmt::format("simulate_bundle: expected {}, got {}", expected, got));
  };
  require(options.cameras >= 2, "at least 2 cameras", options.cameras);
  require(options.points >= 1, "at least 1 point", options.points);
  require(options.track_length >= 2 && options.track_length <= 1000, "a track length from 2 to 1000",
          options.track_length);
  require(options.track_length <= options.cameras, "a track length of at most the number of cameras",
          options.track_length);
  require(options.noise >= 0 && std::isfinite(options.noise), "a noise factor ≥ 0", options.noise);
  require(options.outliers >= 0 && options.outliers <= 1, "a fraction of outliers in [0, 1]",
          options.outliers);
}

}  // namespace

std::string_view to_string(BundleWorld world) {
  switch (world) {
    case BundleWorld::kRing:
      return "ba-ring";
    case BundleWorld::kStreet:
      return "ba-street";
    default:
      return "ba-city";
  }
}

void BundleSimulation::set_to_truth() {
  for (std::size_t k = 0; k < cameras.size(); ++k) graph.set_estimate(cameras[k], true_cameras[k]);
  for (std::size_t k = 0; k < points.size(); ++k) graph.set_estimate(points[k], true_points[k]);
}

BundleSimulation simulate_bundle(BundleWorld world, const BundleOptions& options) {
  check(options);
  return BundleSimulator(world, options).simulate();
}

}  // namespace boxplus
