// SPDX-License-Identifier: BSD-3-Clause
// A fixed lag: only the newest poses are estimated. When a pose is removed, a dense prior on its neighbors
// keeps the information of the removed edges.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/marginalize.h>
#include <boxplus/types/slam2d.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

using namespace boxplus;

int main() {
  constexpr std::size_t kLag = 6;
  constexpr int kSteps = 40;
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const auto noise = [&] { return 0.02 * normal(random); };
  const SE2 step(1, 0, 2 * kPi / kSteps);
  std::vector<Vector2> trees;
  for (int k = 0; k < 12; ++k) trees.emplace_back(8 * std::cos(k), 6 + 8 * std::sin(k));

  // The same drive in two graphs: `all` keeps every pose, `lagged` keeps only the newest poses.
  Graph all, lagged;
  std::vector<VertexHandle<SE2>> all_poses, lagged_poses;
  std::vector<VertexHandle<Vector2>> all_trees, lagged_trees;
  for (const Vector2& tree : trees) {
    const Vector2 guess(tree[0] + 0.5, tree[1] - 0.5);
    all_trees.push_back(all.add_vertex(guess));
    lagged_trees.push_back(lagged.add_vertex(guess));
  }
  SE2 truth;
  for (int k = 0; k < kSteps; ++k, truth = truth * step) {
    const SE2 odometry = step * SE2(noise(), noise(), 0.1 * noise());
    const auto add = [&](Graph& graph, std::vector<VertexHandle<SE2>>& poses,
                         const std::vector<VertexHandle<Vector2>>& points,
                         const std::vector<std::pair<std::size_t, Vector2>>& sightings) {
      const SE2 guess = poses.empty() ? SE2() : graph.estimate(poses.back()) * odometry;
      const auto pose = graph.add_vertex(guess);
      if (poses.empty()) {
        graph.add_edge(Prior<SE2>(SE2()), 1e6, pose);
      } else {
        graph.add_edge(Between<SE2>(odometry), 2500.0, poses.back(), pose);
      }
      for (const auto& [tree, seen] : sightings)
        graph.add_edge(PointObservation2(seen), 2500.0, pose, points[tree]);
      poses.push_back(pose);
      return optimize(graph).converged();
    };
    std::vector<std::pair<std::size_t, Vector2>> sightings;
    for (std::size_t tree = 0; tree < trees.size(); ++tree) {
      const Vector2 seen = truth.inverse_times(trees[tree]);
      if (k == 0 || seen.norm() < 9)
        sightings.emplace_back(tree, Vector2(seen[0] + noise(), seen[1] + noise()));
    }
    if (!add(all, all_poses, all_trees, sightings)) return 1;
    if (!add(lagged, lagged_poses, lagged_trees, sightings)) return 1;
    // [marginalize]
    if (lagged_poses.size() > kLag) {
      marginalize(lagged, {lagged_poses.front()});  // removes the pose and its edges, and adds a prior
      lagged_poses.erase(lagged_poses.begin());
    }
    // [/marginalize]
  }

  double largest = 0;
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const Vector2 difference = all.estimate(all_trees[k]) - lagged.estimate(lagged_trees[k]);
    largest = std::max(largest, difference.norm());
  }
  const SE2 apart = all.estimate(all_poses.back()).inverse() * lagged.estimate(lagged_poses.back());
  std::printf("the lag keeps %zu poses and %zu edges; the full graph has %zu and %zu\n", lagged_poses.size(),
              lagged.edge_count(), all_poses.size(), all.edge_count());
  std::printf("difference from the full graph is below 2 mm: %s for the trees, %s for the last pose\n",
              largest < 0.002 ? "yes" : "no", apart.translation().norm() < 0.002 ? "yes" : "no");
  return largest < 0.002 && apart.translation().norm() < 0.002 ? 0 : 1;
}
