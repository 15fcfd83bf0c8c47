// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/testing/simulate_bundle.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "boxplus/base/error.h"
#include "boxplus/base/progress.h"
#include "testing/bundle_scene.h"
#include "testing/random_numbers.h"
#include "testing/survey.h"

namespace boxplus {
namespace {

using PosedCamera = Product<SE3, BalCamera>;
using Observed = Reprojection<BalCamera>;

/// Each purpose has its own generator, so that another amount of noise does not change the world.
enum class Purpose : std::uint64_t { kPlaces, kIntrinsics, kPoints, kPixels, kStart, kOutliers };
RandomNumbers random_for(Purpose purpose, std::uint64_t seed) {
  constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;  // spreads consecutive numbers over all bits
  return RandomNumbers(seed ^ (static_cast<std::uint64_t>(purpose) * kGolden));
}

void check(const BundleOptions& options) {
  const auto require = [](bool holds, const char* expected, auto value) {
    if (!holds) throw InvalidArgument(fmt::format("simulate_bundle: expected {}, got {}", expected, value));
  };
  require(options.cameras >= 2, "at least 2 cameras", options.cameras);
  require(options.points >= 1, "at least 1 point", options.points);
  require(options.track_length >= 2 && std::isfinite(options.track_length), "a track length ≥ 2",
          options.track_length);
  for (const double noise :
       {options.noise, options.pose_noise, options.point_noise, options.intrinsics_noise})
    require(noise >= 0 && std::isfinite(noise), "noise ≥ 0", noise);
  require(options.outliers >= 0 && options.outliers <= 1, "a fraction of outliers in [0, 1]",
          options.outliers);
}

std::unique_ptr<BundleScene> make_scene(BundleShape shape) {
  if (shape == BundleShape::kRing) return make_ring_scene();
  if (shape == BundleShape::kCollection) return make_collection_scene();
  return make_town_scene(shape == BundleShape::kCity);
}

std::vector<BalCamera> draw_intrinsics(const BundleOptions& options) {
  RandomNumbers random = random_for(Purpose::kIntrinsics, options.seed);
  const int count = options.intrinsics == BundleIntrinsics::kShared ? 1 : options.cameras;
  std::vector<BalCamera> all;
  all.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double f = random.uniform(580, 620), k1 = random.uniform(-0.06, -0.04);
    all.emplace_back(f, k1, random.uniform(0.005, 0.01));
  }
  return all;
}

/// Places the cameras such that points have about options.track_length observations. Returns the mean number
/// of observations of a sample.
double place_cameras(BundleScene& scene, std::span<const BalCamera> intrinsics,
                     const BundleOptions& options) {
  constexpr int kSample = 3000, kSteps = 12;
  const auto mean_length_for = [&](double overlap) {
    scene.place(options.cameras, overlap, random_for(Purpose::kPlaces, options.seed));
    return Survey(scene, intrinsics).mean_length(kSample, random_for(Purpose::kPoints, options.seed));
  };
  double low = 0, high = 1;
  for (int step = 0; step < kSteps; ++step) {
    const double middle = (low + high) / 2;
    (mean_length_for(middle) < options.track_length ? low : high) = middle;
  }
  return mean_length_for((low + high) / 2);
}

/// Adds cameras and points with noisy estimates, and noisy observations.
class BundleBuilder {
 public:
  BundleBuilder(const BundleOptions& options, BundleSimulation& result)
      : options_(options),
        result_(result),
        pixel_random_(random_for(Purpose::kPixels, options.seed)),
        start_random_(random_for(Purpose::kStart, options.seed)),
        outlier_random_(random_for(Purpose::kOutliers, options.seed)) {}

  void add_cameras() {
    const bool is_joint = options_.intrinsics == BundleIntrinsics::kWithPose;
    std::size_t k = 0;
    for (const SE3& pose : result_.true_poses) {
      const SE3 start = noisy(pose);
      if (is_joint) {
        cameras_.push_back(result_.graph.add_vertex(PosedCamera(start, noisy(result_.true_intrinsics[k++]))));
      } else {
        poses_.push_back(result_.graph.add_vertex(start));
      }
    }
    if (is_joint) return;
    for (const BalCamera& camera : result_.true_intrinsics)
      intrinsics_.push_back(result_.graph.add_vertex(noisy(camera)));
  }

  void add_track(const Track& track) {
    const auto point = result_.graph.add_vertex(noisy(track.point));
    result_.graph.set_eliminated(point, true);
    result_.true_points.push_back(track.point);
    for (const Observation& observation : track.observations) {
      const EdgeRef edge = add_edge(static_cast<std::size_t>(observation.camera), point,
                                    Observed(measured(observation.pixel)));
      if (result_.is_outlier.size() == 1) result_.graph.reserve_edges(edge, expected_edges_);
    }
  }

  void expect_edges(std::size_t count) { expected_edges_ = count; }

 private:
  EdgeRef add_edge(std::size_t camera, VertexHandle<Vector3> point, const Observed& observed) {
    if (!cameras_.empty()) return result_.graph.add_edge(observed, cameras_[camera], point);
    const std::size_t own = intrinsics_.size() == 1 ? 0 : camera;
    return result_.graph.add_edge(observed, poses_[camera], point, intrinsics_[own]);
  }

  /// The measured pixel. Records whether it is an outlier.
  Vector2 measured(const Vector2& pixel) {
    const Vector2 noise = options_.noise * normal<2>(pixel_random_);
    const bool is_outlier = outlier_random_.uniform() < options_.outliers;
    result_.is_outlier.push_back(is_outlier);
    return is_outlier ? wrong_pixel(pixel) : Vector2(pixel + noise);
  }

  Vector2 wrong_pixel(const Vector2& pixel) {
    constexpr double kMinError = 20;
    while (true) {
      const double x = outlier_random_.uniform(-BundleImage::kHalfWidth, BundleImage::kHalfWidth);
      const double y = outlier_random_.uniform(-BundleImage::kHalfHeight, BundleImage::kHalfHeight);
      if ((Vector2(x, y) - pixel).norm() > kMinError) return {x, y};
    }
  }

  SE3 noisy(const SE3& pose) {
    constexpr double kTranslation = 0.1, kRotation = 0.5 * kPi / 180;
    const Vector3 translation = options_.pose_noise * kTranslation * normal<3>(start_random_);
    const Vector3 rotation = options_.pose_noise * kRotation * normal<3>(start_random_);
    return pose * SE3(translation, SO3::from_rotation_vector(rotation));
  }
  BalCamera noisy(const BalCamera& camera) {
    const Vector3 deviations(0.01 * camera.parameters[0], 0.01, 0.001);
    return BalCamera(camera.parameters +
                     options_.intrinsics_noise * deviations.cwiseProduct(normal<3>(start_random_)));
  }
  Vector3 noisy(const Vector3& point) {
    constexpr double kDeviation = 0.1;
    return point + options_.point_noise * kDeviation * normal<3>(start_random_);
  }

  template <int N>
  static Vector<double, N> normal(RandomNumbers& random) {
    Vector<double, N> values;
    for (double& value : values) value = random.normal();
    return values;
  }

  const BundleOptions& options_;
  BundleSimulation& result_;
  RandomNumbers pixel_random_, start_random_, outlier_random_;
  std::size_t expected_edges_ = 0;
  std::vector<VertexHandle<PosedCamera>> cameras_;
  std::vector<VertexHandle<SE3>> poses_;
  std::vector<VertexHandle<BalCamera>> intrinsics_;
};

}  // namespace

std::string_view to_string(BundleShape shape) {
  switch (shape) {
    case BundleShape::kRing:
      return "ring";
    case BundleShape::kStreet:
      return "street";
    case BundleShape::kCity:
      return "city";
    default:
      return "collection";
  }
}

void BundleSimulation::set_to_truth(Graph& any) const {
  const bool is_joint = intrinsics == BundleIntrinsics::kWithPose;
  Id id = 0;
  for (std::size_t k = 0; k < true_poses.size(); ++k, ++id) {
    if (is_joint) {
      any.set_estimate(any.vertex<PosedCamera>(id), PosedCamera(true_poses[k], true_intrinsics[k]));
    } else {
      any.set_estimate(any.vertex<SE3>(id), true_poses[k]);
    }
  }
  if (!is_joint) {
    for (const BalCamera& camera : true_intrinsics) any.set_estimate(any.vertex<BalCamera>(id++), camera);
  }
  for (const Vector3& point : true_points) any.set_estimate(any.vertex<Vector3>(id++), point);
}

BundleSimulation simulate_bundle(BundleShape shape, const BundleOptions& options) {
  check(options);
  BundleSimulation result;
  result.intrinsics = options.intrinsics;
  result.true_intrinsics = draw_intrinsics(options);
  const std::unique_ptr<BundleScene> scene = make_scene(shape);
  const double mean_length = place_cameras(*scene, result.true_intrinsics, options);
  result.true_poses = scene->poses();

  BundleBuilder builder(options, result);
  builder.add_cameras();
  constexpr double kMargin = 1.05;  // of the sample
  builder.expect_edges(static_cast<std::size_t>(kMargin * mean_length * options.points));
  const Survey survey(*scene, result.true_intrinsics);
  RandomNumbers random = random_for(Purpose::kPoints, options.seed);
  Track track;
  result.true_points.reserve(static_cast<std::size_t>(options.points));
  for (std::int64_t k = 0; k < options.points; ++k) {
    detail::note_progress(static_cast<double>(k) / static_cast<double>(options.points));
    survey.find(static_cast<int>(k * options.cameras / options.points), random, track);
    builder.add_track(track);
  }
  return result;
}

}  // namespace boxplus
