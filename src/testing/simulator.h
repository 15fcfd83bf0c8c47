// SPDX-License-Identifier: BSD-3-Clause
// Fills a Simulation: adds noisy measurements of true poses and points to its graph.
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "boxplus/testing/simulate.h"
#include "boxplus/types/between.h"
#include "boxplus/types/slam2d/point_observation.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// The standard deviations of relative poses, per axis, in meters and radians.
struct PoseNoise {
  double translation, rotation;
};

template <class Pose>
class Simulator {
  static constexpr int kDim = Manifold<Pose>::kDim, kSpace = kDim == 3 ? 2 : 3;
  static constexpr double kRotationUnit = kDim == 3 ? 1 : 0.5;  // a quaternion's vector part is half an angle

 public:
  Simulator(const SimulationOptions& options, const PoseNoise& noise)
      : random(options.seed),
        outlier_random_(~options.seed),
        outliers_(options.outliers),
        noise_factor_(options.noise) {
    for (int i = 0; i < kDim; ++i) {
      deviation_[i] = i < kSpace ? noise.translation : noise.rotation * kRotationUnit;
      information_[static_cast<std::size_t>(i)] = 1 / (deviation_[i] * deviation_[i]);
    }
  }

  /// Adds the next pose of the trajectory, and an odometry edge from the previous pose.
  void drive_to(const Pose& truth) {
    if (!poses_.empty()) {
      const Between<Pose> edge = measure(truths_.back(), truth);
      const Pose guess = result_.graph.estimate(poses_.back()) * edge.measurement;
      add_pose(truth, guess);
      add(edge, size() - 2, size() - 1, EdgeKind::kOdometry);
      return;
    }
    add_pose(truth, truth);
    result_.graph.fix(poses_[0]);
    result_.truth.fix(true_poses_[0]);
  }

  /// Adds a loop closure between two poses of the trajectory. An outlier mistakes another pose for `from`.
  void recognize(int from, int to) {
    const Between<Pose> edge = measure(truth(from), truth(to));
    const double least_distance = kOutlierDistance * deviation_[0];
    const int mistaken = mistake([&] {
      const int pose = outlier_random_.below(to);
      const bool is_wrong = (truth(pose).translation() - truth(from).translation()).norm() > least_distance;
      return is_wrong && to - pose > 1 ? pose : kNone;
    });
    add(edge, mistaken == kNone ? from : mistaken, to,
        mistaken == kNone ? EdgeKind::kRecognition : EdgeKind::kOutlier);
  }

  int size() const { return static_cast<int>(truths_.size()); }
  const Pose& truth(int pose) const { return truths_[static_cast<std::size_t>(pose)]; }

  /// Adds a point of the plane, which becomes a vertex when it is first seen.
  int add_landmark(const Vector2& point) {
    landmarks_.push_back({point, std::nullopt, std::nullopt});
    return static_cast<int>(landmarks_.size()) - 1;
  }
  const Vector2& landmark(int index) const { return landmarks_[static_cast<std::size_t>(index)].point; }

  /// Observes a landmark from the last pose. An outlier mistakes it for another landmark that was seen
  /// before.
  void observe(int index, double deviation) {
    const Landmark& seen = landmarks_[static_cast<std::size_t>(index)];
    Vector2 noise;
    for (double& entry : noise) entry = random.normal();
    const Vector2 z = truths_.back().inverse_times(seen.point) + noise_factor_ * deviation * noise;
    const int mistaken = mistake([&] {
      if (seen_.empty()) return kNone;
      const int other =
          seen_[static_cast<std::size_t>(outlier_random_.below(static_cast<int>(seen_.size())))];
      return (landmark(other) - seen.point).norm() > kOutlierDistance * deviation ? other : kNone;
    });
    add(z, deviation, mistaken == kNone ? index : mistaken,
        mistaken == kNone ? EdgeKind::kRecognition : EdgeKind::kOutlier);
  }

  Simulation take() { return std::move(result_); }

  RandomNumbers random;

 private:
  static constexpr int kNone = -1;
  static constexpr double kOutlierDistance = 20;  // the least error of an outlier, in standard deviations

  struct Landmark {
    Vector2 point;
    std::optional<VertexHandle<Vector2>> vertex, true_vertex;
  };

  /// Decides at random whether a measurement is an outlier. If so, returns a wrong place, which `draw`
  /// chooses. Otherwise, returns kNone. Uses a separate random generator, so that outliers do not change the
  /// other measurements.
  template <class Draw>
  int mistake(Draw&& draw) {
    if (!(outlier_random_.uniform() < outliers_)) return kNone;
    constexpr int kTrials = 100;  // a tiny world may have no other place
    for (int trial = 0; trial < kTrials; ++trial) {
      if (const int mistaken = draw(); mistaken != kNone) return mistaken;
    }
    return kNone;
  }

  void add_pose(const Pose& truth, const Pose& guess) {
    truths_.push_back(truth);
    poses_.push_back(result_.graph.add_vertex(guess));
    true_poses_.push_back(result_.truth.add_vertex(truth));
  }

  /// Returns a noisy measurement z of the true motion A. Its error e = z⁻¹ A has the distribution N(0, Ω⁻¹).
  Between<Pose> measure(const Pose& from, const Pose& to) {
    Vector<double, kDim> e;
    for (int i = 0; i < kDim; ++i) e[i] = noise_factor_ * deviation_[i] * random.normal();
    return Between<Pose>(from.inverse_times(to) * Manifold<Pose>::oplus(Pose(), e.data()).inverse());
  }

  void add(const Between<Pose>& edge, int from, int to, EdgeKind kind) {
    const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
    const Information information = Information::diagonal(information_);
    result_.edges.push_back(result_.graph.add_edge(edge, information, poses_[i], poses_[j]));
    result_.truth_edges.push_back(result_.truth.add_edge(edge, information, true_poses_[i], true_poses_[j]));
    result_.kinds.push_back(kind);
  }

  void add(const Vector2& z, double deviation, int index, EdgeKind kind) {
    Landmark& seen = landmarks_[static_cast<std::size_t>(index)];
    if (!seen.vertex) {
      seen.vertex = result_.graph.add_vertex(Vector2(result_.graph.estimate(poses_.back()) * z));
      seen.true_vertex = result_.truth.add_vertex(seen.point);
      seen_.push_back(index);
    }
    const Information information(1 / (deviation * deviation));
    const PointObservation2 edge(z);
    result_.edges.push_back(result_.graph.add_edge(edge, information, poses_.back(), *seen.vertex));
    result_.truth_edges.push_back(
        result_.truth.add_edge(edge, information, true_poses_.back(), *seen.true_vertex));
    result_.kinds.push_back(kind);
  }

  RandomNumbers outlier_random_;
  double outliers_;
  double noise_factor_;
  Vector<double, kDim> deviation_;
  std::array<double, kDim> information_;
  Simulation result_;
  std::vector<Pose> truths_;
  std::vector<VertexHandle<Pose>> poses_, true_poses_;
  std::vector<Landmark> landmarks_;
  std::vector<int> seen_;  // the landmarks that have a vertex
};

}  // namespace boxplus
