// SPDX-License-Identifier: BSD-3-Clause
// Visual-inertial odometry: a body flies 200 m with an IMU (200 measurements per second) and a camera (2
// images per second). Between two images, the measurements of the IMU become one edge, which also predicts
// the next pose. The biases of the IMU are estimated along with poses, velocities and landmarks.
#include <boxplus/boxplus.h>
#include <boxplus/testing/simulate_inertial.h>
#include <boxplus/types/ba.h>
#include <boxplus/types/inertial.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <tuple>
#include <vector>

using namespace boxplus;

class Odometry {
 public:
  explicit Odometry(const InertialSimulation& data)
      : data_(data), sights_(data.true_landmarks.size()), landmarks_(data.true_landmarks.size()) {
    mount_ = graph.add_parameter(data.camera_pose);
    camera_ = graph.add_parameter(data.camera);
    // The first pose defines the world. The first velocity is known to 0.2 m/s, and the biases are small.
    const InertialState& first = data.keyframes[0].true_state;
    add_state({first.pose, first.velocity + Vector3(0.1, -0.2, 0.1)}, ImuBias::Zero());
    graph.fix(poses[0]);
    graph.add_edge(Prior(graph.estimate(velocities[0])), 1 / (0.2 * 0.2), velocities[0]);
    const double gyroscope = 1 / (0.01 * 0.01), accelerometer = 1 / (0.1 * 0.1);
    const double weights[] = {gyroscope, gyroscope, gyroscope, accelerometer, accelerometer, accelerometer};
    graph.add_edge(Prior(graph.estimate(biases[0])), Information::diagonal(weights), biases[0]);
  }

  // [motion]
  /// Adds the next keyframe, and the motion to it that the IMU measured.
  void add_keyframe() {
    const auto from = poses.back();
    const auto velocity = velocities.back();
    const auto bias = biases.back();
    Preintegration sum(ImuNoise{}, graph.estimate(bias));
    for (int k = keyframe(poses.size() - 1).next_sample; k < keyframe(poses.size()).next_sample; ++k) {
      const auto& [angular_velocity, specific_force] = data_.samples[static_cast<std::size_t>(k)];
      sum.integrate(angular_velocity, specific_force, data_.sample_seconds);
    }
    add_state(sum.motion().predict(graph.estimate(from), graph.estimate(velocity), sum.motion().bias,
                                   data_.gravity),
              sum.motion().bias);
    graph.add_edge(InertialBetween(sum.motion(), data_.gravity), sum.information(), from, velocity, bias,
                   poses.back(), velocities.back(), biases.back());
  }
  // [/motion]

  /// Adds what the last keyframe sees. A landmark is added as soon as its views determine its position.
  void add_sightings() {
    for (const auto& [landmark, pixel] : keyframe(poses.size() - 1).sightings) {
      const auto k = static_cast<std::size_t>(landmark);
      sights_[k].push_back({poses.back(), pixel});
      if (!landmarks_[k]) {
        const std::optional<Vector3> position = triangulate(sights_[k]);
        if (!position) continue;
        landmarks_[k] = graph.add_vertex(*position);
      }
      for (const Sight& sight : sights_[k])
        graph.add_edge(Reprojection<PinholeCamera>(sight.pixel), 1.0, sight.pose, *landmarks_[k], mount_,
                       camera_);
      sights_[k].clear();  // their edges exist
    }
  }

  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> velocities;
  std::vector<VertexHandle<ImuBias>> biases;

 private:
  struct Sight {
    VertexHandle<SE3> pose;
    Vector2 pixel;
  };

  const InertialSimulation::Keyframe& keyframe(std::size_t k) const { return data_.keyframes[k]; }

  void add_state(const InertialState& state, const ImuBias& bias) {
    poses.push_back(graph.add_vertex(state.pose));
    velocities.push_back(graph.add_vertex(state.velocity));
    biases.push_back(graph.add_vertex(bias));
  }

  /// The point that is nearest to all rays, if the rays differ by at least 5 degrees.
  std::optional<Vector3> triangulate(const std::vector<Sight>& sights) const {
    Matrix<double, 3, 3> sum = Matrix<double, 3, 3>::Zero();
    Vector3 weighted(0, 0, 0), first(0, 0, 0);
    double least_cosine = 1;
    for (const Sight& sight : sights) {
      const SE3 camera = graph.estimate(sight.pose) * data_.camera_pose;
      const auto& k = data_.camera.parameters;  // fx fy cx cy
      const Vector3 ray((sight.pixel[0] - k[2]) / k[0], (sight.pixel[1] - k[3]) / k[1], 1);
      const Vector3 direction = (camera.rotation() * ray).normalized();
      if (&sight == sights.data()) first = direction;
      least_cosine = std::min(least_cosine, direction.dot(first));
      const Matrix<double, 3, 3> across =
          Matrix<double, 3, 3>::Identity() - direction * direction.transpose();
      sum += across;
      weighted += across * camera.translation();
    }
    if (least_cosine > std::cos(5 * kPi / 180)) return std::nullopt;
    return Vector3(Eigen::Matrix3d(sum).ldlt().solve(weighted));
  }

  const InertialSimulation& data_;
  std::vector<std::vector<Sight>> sights_;  // of each landmark that is not in the graph yet
  std::vector<std::optional<VertexHandle<Vector3>>> landmarks_;
  VertexHandle<SE3> mount_;
  VertexHandle<PinholeCamera> camera_;
};

int main() {
  const InertialSimulation data = simulate_inertial({.seconds = 125});
  Odometry odometry(data);
  Graph& graph = odometry.graph;
  odometry.add_sightings();
  // After every 5 s, a few iterations suffice, because the next runs continue from their result.
  Optimizer optimizer(graph, {.start = Start::kCurrent, .max_iterations = 2});
  for (std::size_t k = 1; k < data.keyframes.size(); ++k) {
    odometry.add_keyframe();
    odometry.add_sightings();
    if (k % 10 == 0) std::ignore = optimizer.run();
  }
  optimizer.set_options({.start = Start::kCurrent});
  const Report report = optimizer.run();

  double length = 0, squares = 0, worst = 0;
  for (std::size_t k = 0; k < data.keyframes.size(); ++k) {
    const Vector3 truth = data.keyframes[k].true_state.pose.translation();
    const double error = (graph.estimate(odometry.poses[k]).translation() - truth).norm();
    squares += error * error;
    worst = std::max(worst, error);
    if (k > 0) length += (truth - data.keyframes[k - 1].true_state.pose.translation()).norm();
  }
  const double mean = std::sqrt(squares / static_cast<double>(data.keyframes.size()));
  const ImuBias bias_error = graph.estimate(odometry.biases.back()) - data.keyframes.back().true_bias;
  std::printf("flight of %.0f m; position error %.2f m (RMS), %.2f m (at most), %.2f %% of the path\n",
              length, mean, worst, 100 * worst / length);
  std::printf("chi2 per degree of freedom %.2f; error of the biases %.4f rad/s and %.3f m/s^2\n",
              report.chi2_per_degree(), bias_error.head<3>().norm(), bias_error.tail<3>().norm());
  return report.converged() && length > 200 && worst < 0.005 * length ? 0 : 1;
}
