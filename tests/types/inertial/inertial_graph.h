// SPDX-License-Identifier: BSD-3-Clause
// The graph of a simulated flight with an IMU and a camera, for tests. Its estimates start near the truth.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <array>
#include <vector>

#include "boxplus/covariance/covariance.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate_inertial.h"
#include "boxplus/types/ba.h"
#include "boxplus/types/inertial.h"
#include "testing/random_numbers.h"

namespace boxplus {

/// δᵀ P⁻¹ δ for the step δ from the estimate to the truth.
template <class T>
double squared_error(const Graph& graph, const Covariance& covariance, VertexHandle<T> vertex,
                     const T& truth) {
  Eigen::Matrix<double, Manifold<T>::kDim, 1> delta;
  Manifold<T>::ominus(truth, graph.estimate(vertex), delta.data());
  return delta.dot(covariance.of(vertex).ldlt().solve(delta));
}

/// The error of an optimized vertex is one that its covariance explains. With up to six dimensions, the
/// squared error is above 40 with a probability of 5e-7.
template <class T>
void expect_truth(const Graph& graph, VertexHandle<T> vertex, const T& truth) {
  static_assert(Manifold<T>::kDim <= 6);
  const Covariance certainty = covariance(graph, {vertex});
  ASSERT_TRUE(certainty.ok()) << certainty.message();
  EXPECT_LT(squared_error(graph, certainty, vertex, truth), 40);
}

/// The motion between a keyframe and the next, and its Ω.
inline Preintegration preintegrate(const InertialSimulation& simulation, std::size_t keyframe,
                                   const ImuNoise& noise, const ImuBias& bias) {
  Preintegration sum(noise, bias);
  const int end = simulation.keyframes[keyframe + 1].next_sample;
  for (int k = simulation.keyframes[keyframe].next_sample; k < end; ++k) {
    const auto& [omega, force] = simulation.samples[static_cast<std::size_t>(k)];
    sum.integrate(omega, force, simulation.sample_seconds);
  }
  return sum;
}

struct InertialGraph {
  InertialSimulation simulation;
  Graph graph;
  std::vector<VertexHandle<SE3>> poses;
  std::vector<VertexHandle<Vector3>> velocities;
  std::vector<VertexHandle<ImuBias>> biases;

  /// The first pose is fixed at the truth. The first biases have a prior with the distribution from which
  /// they are drawn.
  explicit InertialGraph(const InertialOptions& options)
      : simulation(simulate_inertial(options)), options_(options), random_(options.seed + 1000) {
    for (const auto& keyframe : simulation.keyframes) {
      poses.push_back(graph.add_vertex(near(keyframe.true_state.pose, 0.02)));
      velocities.push_back(graph.add_vertex(near(keyframe.true_state.velocity, 0.1)));
      biases.push_back(graph.add_vertex(near(keyframe.true_bias, 0.01)));
    }
    graph.set_estimate(poses[0], simulation.keyframes[0].true_state.pose);
    graph.fix(poses[0]);
    Vector<double, 6> sigmas;
    sigmas << Vector3::Constant(options.gyroscope_bias), Vector3::Constant(options.accelerometer_bias);
    const Vector<double, 6> weights = sigmas.cwiseAbs2().cwiseInverse();
    graph.add_edge(Prior(ImuBias(ImuBias::Zero())), Information::diagonal({weights.data(), 6}), biases[0]);
  }

  /// Adds the motions between keyframes. `more` are vertices that follow those of the two keyframes.
  template <class... H>
  void add_motions(const H&... more) {
    for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
      const Preintegration sum = preintegrate(simulation, k, options_.noise, ImuBias::Zero());
      graph.add_edge(InertialBetween(sum.motion(), simulation.gravity), sum.information(), poses[k],
                     velocities[k], biases[k], poses[k + 1], velocities[k + 1], biases[k + 1], more...);
    }
  }

  /// Adds the landmarks that at least three keyframes see.
  void add_landmarks() {
    const double weight = 1 / (options_.pixel_noise * options_.pixel_noise);
    add_landmarks([&](std::size_t k, const Reprojection<PinholeCamera>& edge, const auto&... more) {
      graph.add_edge(edge, weight, poses[k], more...);
    });
  }
  /// The same with custom edges: calls add(keyframe, edge, the vertices of the edge but the pose…).
  template <class Add>
  void add_landmarks(const Add& add) {
    std::vector<int> views(simulation.true_landmarks.size());
    for (const auto& keyframe : simulation.keyframes) {
      for (const auto& sighting : keyframe.sightings) ++views[static_cast<std::size_t>(sighting.landmark)];
    }
    std::vector<VertexHandle<Vector3>> landmarks(views.size());
    for (std::size_t k = 0; k < views.size(); ++k) {
      if (views[k] >= 3) landmarks[k] = graph.add_vertex(near(simulation.true_landmarks[k], 0.1));
    }
    const auto mount = graph.add_parameter(simulation.camera_pose);
    const auto camera = graph.add_parameter(simulation.camera);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (const auto& [landmark, pixel] : simulation.keyframes[i].sightings) {
        const auto k = static_cast<std::size_t>(landmark);
        if (views[k] < 3) continue;
        add(i, Reprojection<PinholeCamera>(pixel), landmarks[k], mount, camera);
      }
    }
  }

 private:
  template <class T>
  T near(const T& x, double size) {
    std::array<double, static_cast<std::size_t>(Manifold<T>::kDim)> step;
    for (double& value : step) value = size * random_.normal();
    return Manifold<T>::oplus(x, step.data());
  }

  InertialOptions options_;
  RandomNumbers random_;
};

}  // namespace boxplus
