// SPDX-License-Identifier: BSD-3-Clause
// Inertial odometry with a fixed lag: a body flies 200 m with an IMU (200 measurements per second) and a
// camera that also measures depth (2 images per second). Only the last 5 s are estimated, so that time and
// memory per image are constant.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/smoother.h>
#include <boxplus/testing/simulate_inertial.h>
#include <boxplus/types/inertial.h>
#include <boxplus/types/slam3d.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <unordered_map>
#include <vector>

using namespace boxplus;

class Odometry {
 public:
  explicit Odometry(const InertialSimulation& data)
      : data_(data), mount_(graph.add_parameter(data.camera_pose)), smoother_(graph, {.lag_s = 5}) {
    // The first pose defines the world. The first velocity is known to 0.2 m/s, and the biases are small.
    const InertialState& first = data.keyframes[0].true_state;
    add_state(0, {first.pose, first.velocity + Vector3(0.1, -0.2, 0.1)}, ImuBias::Zero());
    graph.add_edge(Prior(first.pose), 1e8, pose);
    graph.add_edge(Prior(graph.estimate(velocity)), 1 / (0.2 * 0.2), velocity);
    const double gyroscope = 1 / (0.01 * 0.01), accelerometer = 1 / (0.1 * 0.1);
    const double weights[] = {gyroscope, gyroscope, gyroscope, accelerometer, accelerometer, accelerometer};
    graph.add_edge(Prior(graph.estimate(bias)), Information::diagonal(weights), bias);
  }

  /// Adds keyframe k and what the IMU and the camera measured.
  SmootherReport add_keyframe(std::size_t k) {
    if (k > 0) add_motion(data_.keyframes[k - 1], data_.keyframes[k]);
    for (const auto& sighting : data_.keyframes[k].sightings)
      add_sighting(sighting.landmark, measured_point(data_.keyframes[k], sighting.landmark));
    return smoother_.update();
  }

  Graph graph;
  VertexHandle<SE3> pose;  // the newest one
  VertexHandle<Vector3> velocity;
  VertexHandle<ImuBias> bias;

 private:
  void add_motion(const InertialSimulation::Keyframe& begin, const InertialSimulation::Keyframe& end) {
    const auto from = pose;
    const auto from_velocity = velocity;
    const auto from_bias = bias;
    Preintegration sum(ImuNoise{}, graph.estimate(from_bias));
    for (int k = begin.next_sample; k < end.next_sample; ++k) {
      const auto& [angular_velocity, specific_force] = data_.samples[static_cast<std::size_t>(k)];
      sum.integrate(angular_velocity, specific_force, data_.sample_seconds);
    }
    const InertialMotion& motion = sum.motion();
    add_state(end.time,
              motion.predict(graph.estimate(from), graph.estimate(from_velocity), motion.bias, data_.gravity),
              motion.bias);
    graph.add_edge(InertialBetween(motion, data_.gravity), sum.information(), from, from_velocity, from_bias,
                   pose, velocity, bias);
  }

  // [state]
  /// Adds the unknowns at one time. They leave the lag together.
  void add_state(double seconds, const InertialState& state, const ImuBias& bias_guess) {
    pose = graph.add_vertex(state.pose);
    velocity = graph.add_vertex(state.velocity);
    bias = graph.add_vertex(bias_guess);
    smoother_.set_time(pose, seconds);
    smoother_.set_time(velocity, seconds);
    smoother_.set_time(bias, seconds);
  }
  // [/state]

  // [landmark]
  /// A landmark leaves with the last pose that sees it. If it is seen again later, it is a new vertex.
  void add_sighting(int landmark, const Vector3& seen) {
    auto known = landmarks_.find(landmark);
    if (known == landmarks_.end() || !graph.contains(known->second)) {
      const SE3 camera = graph.estimate(pose) * data_.camera_pose;
      known = landmarks_.insert_or_assign(landmark, graph.add_vertex(Vector3(camera * seen))).first;
    }
    graph.add_edge(OffsetPointObservation3(seen), 1 / (kPointNoise * kPointNoise), pose, known->second,
                   mount_);
  }
  // [/landmark]

  /// What the camera measures: a point in its frame.
  Vector3 measured_point(const InertialSimulation::Keyframe& keyframe, int landmark) {
    const SE3 camera = keyframe.true_state.pose * data_.camera_pose;
    Vector3 point = camera.inverse_times(data_.true_landmarks[static_cast<std::size_t>(landmark)]);
    for (int i = 0; i < 3; ++i) point[i] += kPointNoise * normal_(random_);
    return point;
  }

  static constexpr double kPointNoise = 0.1;  // meters
  const InertialSimulation& data_;
  VertexHandle<SE3> mount_;
  Smoother smoother_;
  std::unordered_map<int, VertexHandle<Vector3>> landmarks_;
  std::mt19937 random_{1};
  std::normal_distribution<double> normal_;
};

int main() {
  const InertialSimulation data = simulate_inertial({.seconds = 125, .landmarks = 200});
  Odometry odometry(data);
  std::size_t vertices = 0;
  double length = 0, worst = 0;
  for (std::size_t k = 0; k < data.keyframes.size(); ++k) {
    const SmootherReport report = odometry.add_keyframe(k);
    if (!report.converged()) {
      std::printf("keyframe %zu: %s\n", k, report.message.c_str());
      return 1;
    }
    vertices = std::max(vertices, odometry.graph.vertex_count());
    const Vector3 truth = data.keyframes[k].true_state.pose.translation();
    worst = std::max(worst, (odometry.graph.estimate(odometry.pose).translation() - truth).norm());
    if (k > 0) length += (truth - data.keyframes[k - 1].true_state.pose.translation()).norm();
  }
  const ImuBias bias_error = odometry.graph.estimate(odometry.bias) - data.keyframes.back().true_bias;
  std::printf("flight of %.0f m with %zu images; the graph has at most %zu vertices\n", length,
              data.keyframes.size(), vertices);
  std::printf("error of the newest position: at most %.2f m, %.2f %% of the path\n", worst,
              100 * worst / length);
  std::printf("error of the biases: %.4f rad/s and %.3f m/s^2\n", bias_error.head<3>().norm(),
              bias_error.tail<3>().norm());
  return length > 200 && worst < 0.01 * length && vertices < 150 ? 0 : 1;
}
