// SPDX-License-Identifier: BSD-3-Clause
// Fills a Simulation: adds noisy measurements of true poses and points to its graph.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

#include "boxplus/base/progress.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/between.h"
#include "boxplus/types/slam2d/point_observation.h"
#include "testing/random_numbers.h"

namespace boxplus {

namespace detail {
/// An error as a vector. An error of one row may be a number.
template <int N, class E>
Vector<double, N> as_vector(const E& error) {
  if constexpr (std::is_arithmetic_v<E>) {
    return Vector<double, N>::Constant(error);
  } else {
    return error;
  }
}
}  // namespace detail

/// The standard deviations of relative poses, per axis, in meters and radians.
struct PoseNoise {
  double translation, rotation;
};

/// The standard deviations of the rows of the error of a relative pose.
template <int N>
struct RowNoise {
  Vector<double, N> deviations;
};

/// A vertex or parameter of the simulated graph, and the same one at the truth.
template <class T>
struct Twin {
  VertexHandle<T> vertex, true_vertex;
};

/// What the robot observes. Each landmark becomes a vertex when it is first seen.
template <class T>
class Landmarks {
 public:
  /// Returns the index of the landmark.
  int add(const T& truth) {
    all_.push_back({truth, std::nullopt});
    return static_cast<int>(all_.size()) - 1;
  }
  const T& truth(int index) const { return all_[index].truth; }
  bool has_vertex(int index) const { return all_[index].twin.has_value(); }

 private:
  template <class Pose>
  friend class Simulator;

  struct Landmark {
    T truth;
    std::optional<Twin<T>> twin;
  };
  std::vector<Landmark> all_;
  std::vector<int> seen_;  // the landmarks that have a vertex
};

template <class Pose>
class Simulator {
  static constexpr int kDim = Manifold<Pose>::kDim, kSpace = kDim == 3 ? 2 : 3;
  static constexpr double kRotationUnit = kDim == 3 ? 1 : 0.5;  // a quaternion's vector part is half an angle

 public:
  Simulator(const SimulationOptions& options, const PoseNoise& noise)
      : Simulator(options, row_noise(noise)) {}

  Simulator(const SimulationOptions& options, const RowNoise<kDim>& noise)
      : random(options.seed),
        outlier_random_(~options.seed),
        outliers_(options.outliers),
        expected_poses_(options.poses),
        noise_factor_(options.noise),
        deviation_(noise.deviations) {
    for (int i = 0; i < kDim; ++i) information_[i] = 1 / (deviation_[i] * deviation_[i]);
  }

  /// Adds the next pose of the trajectory, and an odometry edge from the previous pose. If `has_edge` is
  /// false, the odometry is only used for the initial estimate.
  void drive_to(const Pose& truth, bool has_edge = true) {
    detail::note_progress(std::min(1.0, size() / expected_poses_));
    if (!poses_.empty()) {
      const Between<Pose> edge = measure(truths_.back(), truth);
      const Pose guess = result_.graph.estimate(poses_.back()) * edge.measurement;
      add_pose(truth, guess);
      if (has_edge) add(edge, size() - 2, size() - 1, EdgeKind::kOdometry);
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
  const Pose& truth(int pose) const { return truths_[pose]; }

  /// The estimate of a pose in the simulated graph.
  const Pose& guess_of(int pose) const { return result_.graph.estimate(poses_[pose]); }
  /// The estimate of the last pose in the simulated graph.
  const Pose& last_guess() const { return result_.graph.estimate(poses_.back()); }

  /// Adds another unknown, such as the pose of a sensor on the robot.
  template <class T>
  Twin<T> add_vertex(const T& truth, const T& guess) {
    return {result_.graph.add_vertex(guess), result_.truth.add_vertex(truth)};
  }
  template <class T>
  Twin<T> add_parameter(const T& truth) {
    return {result_.graph.add_parameter(truth), result_.truth.add_parameter(truth)};
  }
  template <class T>
  const T& guess(const Twin<T>& twin) const {
    return result_.graph.estimate(twin.vertex);
  }

  /// Adds a point of the plane.
  int add_landmark(const Vector2& point) { return points_.add(point); }
  const Vector2& landmark(int index) const { return points_.truth(index); }

  /// Observes a point from the last pose.
  void observe(int index, double deviation) {
    Vector2 noise;
    for (double& entry : noise) entry = random.normal();
    const Vector2 z = truths_.back().inverse_times(landmark(index)) + noise_factor_ * deviation * noise;
    const Vector2 seen = landmark(index);
    observe(size() - 1, points_, index, PointObservation2(z), Information(1 / (deviation * deviation)),
            Vector2(last_guess() * z),
            [&](const Vector2& other) { return (other - seen).norm() > kOutlierDistance * deviation; });
  }

  /// Observes a landmark from the last pose with an edge whose vertices are this pose, the landmark, and
  /// `sensors`. The rows of its error have these standard deviations. `guess` is the estimate of the landmark
  /// if it has not been seen before.
  template <class T, class E, int N, class... S>
  void observe(Landmarks<T>& landmarks, int index, const E& edge, const Vector<double, N>& deviations,
               const T& guess, const Twin<S>&... sensors) {
    observe_from(size() - 1, landmarks, index, edge, deviations, guess, sensors...);
  }

  /// The same from any pose.
  template <class T, class E, int N, class... S>
  void observe_from(int pose, Landmarks<T>& landmarks, int index, const E& edge,
                    const Vector<double, N>& deviations, const T& guess, const Twin<S>&... sensors) {
    std::array<double, N> information;
    for (int i = 0; i < N; ++i) information[i] = 1 / (deviations[i] * deviations[i]);
    const auto is_wrong = [&](const T& other) {
      const auto error = edge.error(truth(pose), other, result_.truth.estimate(sensors.true_vertex)...);
      return detail::as_vector<N>(error).cwiseQuotient(deviations).norm() > kOutlierDistance;
    };
    observe(pose, landmarks, index, edge, Information::diagonal(information), guess, is_wrong, sensors...);
  }

  /// Adds an absolute measurement of the last pose, with an edge whose vertices are this pose and `sensors`.
  template <class E, class... S>
  void measure_pose(const E& edge, const Information& information, const Twin<S>&... sensors) {
    result_.edges.push_back(result_.graph.add_edge(edge, information, poses_.back(), sensors.vertex...));
    result_.truth_edges.push_back(
        result_.truth.add_edge(edge, information, true_poses_.back(), sensors.true_vertex...));
    result_.kinds.push_back(EdgeKind::kRecognition);
  }

  Simulation take() { return std::move(result_); }

  RandomNumbers random;

 private:
  static RowNoise<kDim> row_noise(const PoseNoise& noise) {
    RowNoise<kDim> rows;
    for (int i = 0; i < kDim; ++i)
      rows.deviations[i] = i < kSpace ? noise.translation : noise.rotation * kRotationUnit;
    return rows;
  }

  static constexpr int kNone = -1;
  static constexpr double kOutlierDistance = 20;  // the least error of an outlier, in standard deviations

  /// An outlier mistakes the landmark for another one that was seen before, and that `is_wrong`.
  template <class T, class E, class IsWrong, class... S>
  void observe(int pose, Landmarks<T>& landmarks, int index, const E& edge, const Information& information,
               const T& guess, IsWrong&& is_wrong, const Twin<S>&... sensors) {
    const auto from = static_cast<std::size_t>(pose);
    const int mistaken = mistake([&] {
      if (landmarks.seen_.empty()) return kNone;
      const auto count = static_cast<int>(landmarks.seen_.size());
      const int other = landmarks.seen_[outlier_random_.below(count)];
      return is_wrong(landmarks.truth(other)) ? other : kNone;
    });
    const int observed = mistaken == kNone ? index : mistaken;
    auto& landmark = landmarks.all_[observed];
    if (!landmark.twin) {
      landmark.twin = add_vertex(landmark.truth, guess);
      landmarks.seen_.push_back(observed);
    }
    result_.edges.push_back(
        result_.graph.add_edge(edge, information, poses_[from], landmark.twin->vertex, sensors.vertex...));
    result_.truth_edges.push_back(result_.truth.add_edge(edge, information, true_poses_[from],
                                                         landmark.twin->true_vertex, sensors.true_vertex...));
    result_.kinds.push_back(mistaken == kNone ? EdgeKind::kRecognition : EdgeKind::kOutlier);
  }

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

  RandomNumbers outlier_random_;
  double outliers_, expected_poses_;
  double noise_factor_;
  Vector<double, kDim> deviation_;
  std::array<double, kDim> information_;
  Simulation result_;
  std::vector<Pose> truths_;
  std::vector<VertexHandle<Pose>> poses_, true_poses_;
  Landmarks<Vector2> points_;
};

}  // namespace boxplus
