// SPDX-License-Identifier: BSD-3-Clause
// Small graphs that several tests use.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"

namespace boxplus {

/// Adds `count` poses around a closed circle, with noisy measurements and estimates that drift. No vertex is
/// fixed.
inline std::vector<VertexHandle<SE2>> add_noisy_circle(Graph& graph, int count, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<> normal(0, 0.02);
  const double turn = 2 * kPi / count;
  const auto noisy_step = [&] { return SE2(1 + normal(random), normal(random), turn + normal(random)); };
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2(1, 2, 0.5))};
  for (int i = 0; i < count; ++i) {
    const SE2 step = noisy_step();
    if (i + 1 < count) poses.push_back(graph.add_vertex(graph.estimate(poses.back()) * step));
    const auto to = poses[static_cast<std::size_t>((i + 1) % count)];
    graph.add_edge(Between(step), Information::diagonal(std::vector{400.0, 400.0, 900.0}),
                   poses[static_cast<std::size_t>(i)], to);
  }
  return poses;
}

/// Adds a noisy grid of `side` × `side` × `side` 3-D poses. Edges connect neighbors in all three directions.
inline std::vector<VertexHandle<SE3>> add_noisy_grid(Graph& graph, int side, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<> normal(0, 1);
  std::vector<SE3> truth;
  std::vector<VertexHandle<SE3>> poses;
  const auto perturbed = [&](const SE3& x, double by) {
    double delta[6];
    for (double& d : delta) d = by * normal(random);
    return Manifold<SE3>::oplus(x, delta);
  };
  const auto index = [side](int x, int y, int z) {
    return static_cast<std::size_t>((z * side + y) * side + x);
  };
  for (int k = 0; k < side * side * side; ++k) {
    const int x = k % side, y = k / side % side, z = k / side / side;
    truth.push_back(perturbed(SE3(Vector3(x, y, z), detail::Quaternion<double>::identity()), 0.1));
    poses.push_back(graph.add_vertex(perturbed(truth.back(), 0.05)));
  }
  const auto link = [&](std::size_t a, std::size_t b) {
    graph.add_edge(Between(perturbed(truth[a].inverse() * truth[b], 0.02)), 2500.0, poses[a], poses[b]);
  };
  for (int z = 0; z < side; ++z) {
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        if (x + 1 < side) link(index(x, y, z), index(x + 1, y, z));
        if (y + 1 < side) link(index(x, y, z), index(x, y + 1, z));
        if (z + 1 < side) link(index(x, y, z), index(x, y, z + 1));
      }
    }
  }
  return poses;
}

}  // namespace boxplus
