// SPDX-License-Identifier: BSD-3-Clause
// A small bundle adjustment problem: cameras on an arc, points in front of them, reprojection errors.
#pragma once

#include <random>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

/// The reprojection error in pixels: a point (in the world frame) is projected into a pinhole camera (its
/// pose is T_world_camera), and the observation (u, v) is subtracted.
struct Reprojection {
  double u, v;
  static constexpr double kFocalLength = 500;
  template <class S>
  Eigen::Matrix<S, 2, 1> error(const BasicSE3<S>& camera, const Eigen::Matrix<S, 3, 1>& point) const {
    const Vector<S, 3> p = camera.inverse_times(point);
    return {kFocalLength * p[0] / p[2] - u, kFocalLength * p[1] / p[2] - v};
  }
};

/// A measured relative motion between two cameras.
struct Odometry {
  SE3 motion;
  template <class S>
  Vector<S, 6> error(const BasicSE3<S>& a, const BasicSE3<S>& b) const {
    return motion.cast<S>().inverse_times(a.inverse_times(b)).minimal();
  }
};

struct Bundle {
  Graph graph;
  std::vector<VertexHandle<SE3>> cameras;
  std::vector<VertexHandle<Eigen::Vector3d>> points;
};

inline SE3 camera_pose(int k) {
  const Eigen::Vector3d position(0.8 * k, 0.1 * k * k / (1 + k), 0.05 * k);
  return SE3::from_minimal((Vector<double, 6>() << position, 0.01 * k, -0.02 * k, 0.03).finished());
}

/// Only two cameras see every third point. All cameras see all other points. The first camera is fixed.
/// Odometry between successive cameras determines the scale. Estimates and observations are noisy. If
/// `eliminate` is true, the points are marked for elimination.
inline Bundle make_bundle(int cameras, int points, bool eliminate) {
  Bundle bundle;
  Graph& graph = bundle.graph;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto noise = [&](double scale) {
    return (scale * Eigen::Vector3d(normal(random), normal(random), normal(random))).eval();
  };
  for (int k = 0; k < cameras; ++k) {
    Vector<double, 6> shift = Vector<double, 6>::Zero();
    if (k > 0) shift << noise(0.02), noise(0.002);
    bundle.cameras.push_back(graph.add_vertex(Manifold<SE3>::oplus(camera_pose(k), shift.data())));
  }
  for (int k = 0; k + 1 < cameras; ++k) {
    const Odometry odometry{camera_pose(k).inverse_times(camera_pose(k + 1))};
    const auto c = static_cast<std::size_t>(k);
    graph.add_edge(odometry, 100.0, bundle.cameras[c], bundle.cameras[c + 1]);
  }
  graph.fix(bundle.cameras[0]);
  for (int p = 0; p < points; ++p) {
    const Eigen::Vector3d truth = Eigen::Vector3d(0.4 * cameras, 0, 8) + noise(1.0);
    const auto point = graph.add_vertex((truth + noise(0.05)).eval());
    bundle.points.push_back(point);
    graph.set_eliminated(point, eliminate);
    for (int k = 0; k < cameras; ++k) {
      const bool seen = p % 3 != 0 || k == p % cameras || k == (p + 1) % cameras;
      if (!seen) continue;
      const Eigen::Vector2d pixel = Reprojection{0, 0}.error(camera_pose(k), truth) + noise(0.5).head<2>();
      graph.add_edge(Reprojection{pixel[0], pixel[1]}, bundle.cameras[static_cast<std::size_t>(k)], point);
    }
  }
  return bundle;
}

}  // namespace boxplus
