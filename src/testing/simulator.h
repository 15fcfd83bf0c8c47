// SPDX-License-Identifier: BSD-3-Clause
// Fills a Simulation: true poses and points come in, noisy measurements and their graph go out.
#pragma once

#include <array>
#include <utility>

#include "boxplus/testing/simulate.h"
#include "boxplus/types/between.h"
#include "boxplus/types/slam2d/point_observation.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// Standard deviations of relative poses: per axis, in metres and radians.
struct PoseNoise {
  double translation, rotation;
};

template <class Pose>
class Simulator {
  static constexpr int kDim = Manifold<Pose>::kDim, kSpace = kDim == 3 ? 2 : 3;
  static constexpr double kRotationUnit = kDim == 3 ? 1 : 0.5;  // quaternion vectors are half angles

 public:
  Simulator(const SimulationOptions& options, const PoseNoise& noise)
      : random(options.seed), noise_factor_(options.noise) {
    for (int i = 0; i < kDim; ++i) {
      deviation_[i] = i < kSpace ? noise.translation : noise.rotation * kRotationUnit;
      information_[static_cast<std::size_t>(i)] = 1 / (deviation_[i] * deviation_[i]);
    }
  }

  /// The next pose of the trajectory, with an odometry edge from the last one.
  void drive_to(const Pose& truth) {
    if (!poses_.empty()) {
      const Between<Pose> edge = measure(truths_.back(), truth);
      const Pose guess = result_.graph.estimate(poses_.back()) * edge.measurement;
      add_pose(truth, guess);
      add(edge, static_cast<int>(poses_.size()) - 2, static_cast<int>(poses_.size()) - 1);
      return;
    }
    add_pose(truth, truth);
    result_.graph.fix(poses_[0]);
    result_.truth.fix(true_poses_[0]);
  }

  /// A loop closure between two poses of the trajectory.
  void recognise(int from, int to) {
    add(measure(truths_[static_cast<std::size_t>(from)], truths_[static_cast<std::size_t>(to)]), from, to);
  }

  int size() const { return static_cast<int>(truths_.size()); }
  const Pose& truth(int pose) const { return truths_[static_cast<std::size_t>(pose)]; }

  /// Sees a point of the plane; `landmark` is empty at first and then its handles in graph and truth.
  using Landmark = std::vector<VertexHandle<Vector2>>;
  void observe(const Vector2& point, double deviation, Landmark& landmark) {
    Vector2 noise;
    for (double& entry : noise) entry = random.normal();
    const Vector2 z = truths_.back().inverse_times(point) + noise_factor_ * deviation * noise;
    if (landmark.empty()) {
      landmark.push_back(result_.graph.add_vertex(Vector2(result_.graph.estimate(poses_.back()) * z)));
      landmark.push_back(result_.truth.add_vertex(point));
    }
    const Information information(1 / (deviation * deviation));
    result_.edges.push_back(
        result_.graph.add_edge(PointObservation2(z), information, poses_.back(), landmark[0]));
    result_.truth_edges.push_back(
        result_.truth.add_edge(PointObservation2(z), information, true_poses_.back(), landmark[1]));
  }

  Simulation take() { return std::move(result_); }

  RandomNumbers random;

 private:
  void add_pose(const Pose& truth, const Pose& guess) {
    truths_.push_back(truth);
    poses_.push_back(result_.graph.add_vertex(guess));
    true_poses_.push_back(result_.truth.add_vertex(truth));
  }

  /// z with e = z⁻¹ A distributed as N(0, Ω⁻¹), where A is the true motion.
  Between<Pose> measure(const Pose& from, const Pose& to) {
    Vector<double, kDim> e;
    for (int i = 0; i < kDim; ++i) e[i] = noise_factor_ * deviation_[i] * random.normal();
    return Between<Pose>(from.inverse_times(to) * Manifold<Pose>::oplus(Pose(), e.data()).inverse());
  }

  void add(const Between<Pose>& edge, int from, int to) {
    const auto i = static_cast<std::size_t>(from), j = static_cast<std::size_t>(to);
    const Information information = Information::diagonal(information_);
    result_.edges.push_back(result_.graph.add_edge(edge, information, poses_[i], poses_[j]));
    result_.truth_edges.push_back(result_.truth.add_edge(edge, information, true_poses_[i], true_poses_[j]));
  }

  double noise_factor_;
  Vector<double, kDim> deviation_;
  std::array<double, kDim> information_;
  Simulation result_;
  std::vector<Pose> truths_;
  std::vector<VertexHandle<Pose>> poses_, true_poses_;
};

}  // namespace boxplus
