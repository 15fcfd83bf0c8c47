// SPDX-License-Identifier: BSD-3-Clause
// A robot that drives around in space, with noisy odometry, for tests of what its sensors measure.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam3d.h"
#include "testing/random_numbers.h"
#include "types/expect_jacobians.h"

namespace boxplus {

inline SE3 random_pose(RandomNumbers& random, double size) {
  double v[6];
  for (double& value : v) value = random.uniform(-size, size);
  return pose(v[0], v[1], v[2], v[3], v[4], v[5]);
}

inline Vector3 random_vector(RandomNumbers& random) {
  return {random.normal(), random.normal(), random.normal()};
}

inline Plane3 random_plane(RandomNumbers& random) {
  const Vector3 n = random_vector(random);
  return {Vector<double, 4>(n[0], n[1], n[2], random.uniform(-3, 3))};
}

/// The first pose is fixed at its true place. The others start where the odometry says.
struct SensorWorld {
  RandomNumbers random;
  Graph graph;
  std::vector<SE3> truths;
  std::vector<VertexHandle<SE3>> poses;

  explicit SensorWorld(std::uint64_t seed) : random(seed) {
    constexpr int kPoses = 40;
    constexpr double kTranslation = 0.05, kRotation = 0.02;
    for (int i = 0; i < kPoses; ++i) {
      const double angle = 4 * kPi * i / kPoses;
      truths.push_back(pose(3 * std::cos(angle), 3 * std::sin(angle), std::sin(3 * angle), 0, 0, angle) *
                       random_pose(random, 0.2));
      if (i == 0) {
        poses.push_back(graph.add_vertex(truths[0]));
        graph.fix(poses[0]);
        continue;
      }
      Vector<double, 6> noise = normal<6>();
      noise.head<3>() *= kTranslation;
      noise.tail<3>() *= kRotation / 2;  // the vector part of a quaternion is half an angle
      const SE3 z =
          truths[i - 1].inverse_times(truths[i]) * Manifold<SE3>::oplus(SE3(), noise.data()).inverse();
      poses.push_back(graph.add_vertex(graph.estimate(poses[i - 1]) * z));
      graph.add_edge(Between(z), Information::se3_sigmas(kTranslation, kRotation), poses[i - 1], poses[i]);
    }
  }

  /// Independent numbers with mean 0 and variance 1.
  template <int N>
  Vector<double, N> normal() {
    Vector<double, N> v;
    for (double& value : v) value = random.normal();
    return v;
  }
};

/// A χ² variable with n degrees of freedom has mean n and standard deviation √(2n).
inline void expect_chi2_of_noise(Graph& graph) {
  const Report report = optimize(graph);
  EXPECT_TRUE(report.converged()) << report.message;
  const auto n = static_cast<double>(report.degrees_of_freedom);
  EXPECT_GT(n, 50);
  EXPECT_NEAR(report.chi2_final, n, 5 * std::sqrt(2 * n));
}

}  // namespace boxplus
