// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>

#include "boxplus/types/slam2d.h"
#include "testing/grid_walk.h"
#include "testing/robot_options.h"
#include "testing/simulator.h"

namespace boxplus {
namespace {

/// The place of a landmark, from the directions in which some poses see it: the point with the smallest sum
/// of squared distances from the lines of sight. There is no such point if the directions hardly differ, or
/// if it is behind a pose.
class Triangulation {
 public:
  /// `angle`: of the direction in the world.
  void add(const Vector2& place, double angle) {
    const Vector2 d(std::cos(angle), std::sin(angle));
    const Matrix<double, 2, 2> across = Matrix<double, 2, 2>::Identity() - d * d.transpose();
    H_ += across;
    b_ += across * place;
    places_.push_back(place);
    directions_.push_back(d);
  }

  std::optional<Vector2> point() const {
    constexpr double kLeastSpread = 0.2;  // of the lines of sight: the smallest eigenvalue of the sum
    const double mean = 0.5 * (H_(0, 0) + H_(1, 1)), determinant = H_(0, 0) * H_(1, 1) - H_(0, 1) * H_(1, 0);
    const double least = mean - std::sqrt(std::max(0.0, mean * mean - determinant));
    if (least < kLeastSpread) return std::nullopt;
    // Cramer's rule, without the division by the determinant.
    const Vector2 point(H_(1, 1) * b_[0] - H_(0, 1) * b_[1], H_(0, 0) * b_[1] - H_(1, 0) * b_[0]);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      if (directions_[k].dot(point / determinant - places_[k]) <= 0) return std::nullopt;
    }
    return point / determinant;
  }

 private:
  Matrix<double, 2, 2> H_ = Matrix<double, 2, 2>::Zero();
  Vector2 b_ = Vector2(0, 0);
  std::vector<Vector2> places_, directions_;
};

class PlaneRobot {
 public:
  explicit PlaneRobot(const PlaneRobotOptions& options)
      : options_(options),
        world_(world_seed(options.seed)),
        simulator_(simulation_options(options), {0.05, 0.01}),
        walk_(options.world_size) {
    place_landmarks();
    place_segments();
  }

  Simulation run() {
    for (int k = 0; k < options_.poses; ++k) {
      simulator_.drive_to(walk_.pose(), options_.has_odometry);
      look();
      walk_.step(world_);
    }
    add_bearings();
    return simulator_.take();
  }

 private:
  struct Sighting {
    int pose;
    double bearing;
  };

  void place_landmarks() {
    const double half = options_.world_size / 2;
    sightings_.resize(static_cast<std::size_t>(options_.landmarks));
    for (int k = 0; k < options_.landmarks; ++k) {
      const double x = world_.uniform(-half, half), y = world_.uniform(-half, half);
      point_cells_.add({x, y}, points_.add({x, y}));
    }
  }

  void place_segments() {
    const int grid = options_.segment_grid;
    for (int k = 0; k < options_.segments; ++k) {
      const double x = world_.below(2 * grid + 1) - grid, y = world_.below(2 * grid + 1) - grid;
      const int direction = world_.below(4);
      const double length = world_.uniform(options_.min_segment_length, options_.max_segment_length);
      constexpr int kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
      const Segment2 segment{{x, y}, {x + length * kDx[direction], y + length * kDy[direction]}};
      segment_cells_.add(0.5 * (segment.first + segment.second), segments_.add(segment));
    }
  }

  void look() {
    const SE2 pose = simulator_.truth(simulator_.size() - 1);
    if (has(options_, PlaneSensor::kPoints)) see_points(pose);
    if (has(options_, PlaneSensor::kBearings)) see_bearings(pose);
    if (has(options_, PlaneSensor::kSegments)) see_segments(pose);
    if (has(options_, PlaneSensor::kPoses)) {
      revisits_.arrive(pose.translation(), random(),
                       [&](int other) { simulator_.recognize(other, simulator_.size() - 1); });
    }
    if (simulator_.size() < 2) return;  // the first pose is fixed, so nothing needs to measure it
    if (has(options_, PlaneSensor::kCompass)) {
      constexpr double kDeviation = 0.02;
      const double heading = pose.theta() + options_.noise * kDeviation * random().normal();
      simulator_.measure_pose(Prior<SE2>(SE2(pose.x(), pose.y(), heading)),
                              Information::diagonal(std::array{0.0, 0.0, 1 / (kDeviation * kDeviation)}));
    }
    if (has(options_, PlaneSensor::kGps)) {
      const Vector2 deviations(0.3, 0.3);
      simulator_.measure_pose(
          PositionPrior(noisy<2>(pose.translation(), deviations, options_.noise, random())),
          Information(1 / (deviations[0] * deviations[0])));
    }
  }

  void see_points(const SE2& pose) {
    const Vector2 deviations(0.05, 0.05);
    point_cells_.around(pose.translation(), Reach::kRange, [&](int index) {
      const Vector2 seen = pose.inverse_times(points_.truth(index));
      if (!Reach::has(seen)) return;
      const Vector2 z = noisy<2>(seen, deviations, options_.noise, random());
      simulator_.observe(points_, index, PointObservation2(z), deviations,
                         Vector2(simulator_.last_guess() * z));
    });
  }

  void see_bearings(const SE2& pose) {
    point_cells_.around(pose.translation(), Reach::kRange, [&](int index) {
      const Vector2 seen = pose.inverse_times(points_.truth(index));
      constexpr double kTooNear = 0.5;  // a bearing from so near hardly restricts the pose
      if (!Reach::has(seen) || seen.norm() < kTooNear) return;
      const double bearing =
          std::atan2(seen[1], seen[0]) + options_.noise * kBearingDeviation * random().normal();
      sightings_[static_cast<std::size_t>(index)].push_back({simulator_.size() - 1, bearing});
    });
  }

  /// Adds the bearings of landmarks that have a vertex already, or that the first bearings determine.
  void add_bearings() {
    for (int index = 0; index < options_.landmarks; ++index) {
      const std::vector<Sighting>& sightings = sightings_[static_cast<std::size_t>(index)];
      Triangulation triangulation;
      std::optional<Vector2> guess;
      if (points_.has_vertex(index)) guess = Vector2(0, 0);
      for (std::size_t k = 0; k < sightings.size() && !guess; ++k) {
        const SE2& pose = simulator_.guess_of(sightings[k].pose);
        triangulation.add(pose.translation(), pose.theta() + sightings[k].bearing);
        guess = triangulation.point();
      }
      if (!guess) continue;
      for (const auto& [pose, bearing] : sightings) {
        simulator_.observe_from(pose, points_, index, BearingObservation2(detail::normalize_angle(bearing)),
                                Vector<double, 1>(Vector<double, 1>::Constant(kBearingDeviation)), *guess);
      }
    }
  }

  void see_segments(const SE2& pose) {
    const double reach = Reach::kRange + options_.max_segment_length / 2;
    segment_cells_.around(pose.translation(), reach, [&](int index) { see_segment(pose, index); });
  }

  /// A segment gets its vertex when both ends are in reach. Later, one end or a part between the ends
  /// suffices.
  void see_segment(const SE2& pose, int index) {
    const Segment2& truth = segments_.truth(index);
    const Vector2 first = pose.inverse_times(truth.first), second = pose.inverse_times(truth.second);
    const double angle = detail::normal_angle(first, second);
    const Vector2 normal(std::cos(angle), std::sin(angle));
    const bool sees_first = Reach::has(first), sees_second = Reach::has(second);
    const Segment2 unused;
    if (sees_first && sees_second) {
      const Vector<double, 4> deviations(0.05, 0.05, 0.05, 0.05);
      const Vector<double, 4> z = noisy<4>(Vector<double, 4>(first[0], first[1], second[0], second[1]),
                                           deviations, options_.noise, random());
      const SE2& guess = simulator_.last_guess();
      simulator_.observe(segments_, index, SegmentObservation2(z), deviations,
                         Segment2{guess * Vector2(z[0], z[1]), guess * Vector2(z[2], z[3])});
    } else if (!segments_.has_vertex(index)) {
      return;
    } else if (sees_first || sees_second) {
      const Vector3 deviations(0.05, 0.05, 0.02);
      const Vector2& end = sees_first ? first : second;
      const Vector3 z = noisy<3>(Vector3(end[0], end[1], angle), deviations, options_.noise, random());
      simulator_.observe(segments_, index, SegmentEndObservation2(z, sees_second), deviations, unused);
    } else if (Reach::has(nearest_to_origin(first, second))) {
      const Vector2 deviations(0.02, 0.05);
      const Vector2 z = noisy<2>(Vector2(angle, normal.dot(first)), deviations, options_.noise, random());
      simulator_.observe(segments_, index, SegmentLineObservation2(z), deviations, unused);
    }
  }

  static Vector2 nearest_to_origin(const Vector2& first, const Vector2& second) {
    const Vector2 along = second - first;
    const double t = std::clamp(-first.dot(along) / along.squaredNorm(), 0.0, 1.0);
    return first + t * along;
  }

  RandomNumbers& random() { return simulator_.random; }

  static constexpr double kBearingDeviation = 0.01;
  const PlaneRobotOptions& options_;
  RandomNumbers world_;
  Simulator<SE2> simulator_;
  GridWalk walk_;
  Landmarks<Vector2> points_;
  Landmarks<Segment2> segments_;
  PlaneCells point_cells_{Reach::kRange}, segment_cells_{Reach::kRange};
  std::vector<std::vector<Sighting>> sightings_;  // of each landmark
  Revisits revisits_;
};

}  // namespace

std::string_view to_string(PlaneSensor sensor) {
  constexpr std::array<std::string_view, kPlaneSensors.size()> kNames{"points",  "bearings", "poses",
                                                                      "compass", "gps",      "segments"};
  return kNames[static_cast<std::size_t>(sensor)];
}

Simulation simulate_robot(const PlaneRobotOptions& options) {
  check_robot(options);
  require_option(options.segments >= 0, "a number of segments ≥ 0", options.segments);
  require_option(options.segment_grid >= 1, "a segment grid ≥ 1", options.segment_grid);
  require_option(options.min_segment_length > 0, "a minimal length of segments > 0",
                 options.min_segment_length);
  require_option(
      std::isfinite(options.max_segment_length) && options.max_segment_length >= options.min_segment_length,
      "a maximal length of segments that is not below the minimal one", options.max_segment_length);
  return PlaneRobot(options).run();
}

}  // namespace boxplus
