// SPDX-License-Identifier: BSD-3-Clause
// A fixed-lag smoother, which estimates only the newest poses. When it removes a pose, it adds a dense prior
// on the neighbors of the pose. The prior keeps the information of the removed edges.
#include <boxplus/boxplus.h>
#include <boxplus/types/dense_prior.h>
#include <boxplus/types/slam2d.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace boxplus;

// [marginalize]
/// Removes a pose and its edges. One new edge, a dense prior on the neighbors of the pose, keeps the
/// information of the removed edges.
void marginalize(Graph& graph, VertexHandle<SE2> pose) {
  std::vector<VertexHandle<SE2>> poses;
  std::vector<VertexHandle<Vector2>> points;
  std::vector<SE2> pose_means;
  std::vector<Vector2> point_means;
  std::map<VertexRef, int> column{{pose, 0}};  // the first column of each vertex in H
  const std::vector<EdgeRef> edges = graph.edges(pose);
  for (const EdgeRef& edge : edges) {
    for (const VertexRef& vertex : graph.vertices(edge)) {
      if (!column.emplace(vertex, 0).second) continue;
      if (graph.tangent_dim(vertex) == 3) {
        poses.push_back(graph.typed<SE2>(vertex));
        pose_means.push_back(graph.estimate(poses.back()));
      } else {
        points.push_back(graph.typed<Vector2>(vertex));
        point_means.push_back(graph.estimate(points.back()));
      }
    }
  }
  int size = 3;
  for (const auto& vertex : poses) column[vertex] = std::exchange(size, size + 3);
  for (const auto& vertex : points) column[vertex] = std::exchange(size, size + 2);

  // Builds the normal equations H δ = −b from the edges of the pose.
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
  for (const EdgeRef& edge : edges) {
    const std::vector<VertexRef> vertices = graph.vertices(edge);
    const std::vector<Eigen::MatrixXd> J = graph.jacobian(edge);
    const std::vector<double> error = graph.error(edge);
    const Eigen::Map<const Eigen::VectorXd> e(error.data(), static_cast<Eigen::Index>(error.size()));
    const Eigen::MatrixXd Omega = graph.weight(edge) * graph.information(edge).matrix();
    for (std::size_t i = 0; i < J.size(); ++i) {
      const int at = column[vertices[i]];
      b.segment(at, J[i].cols()) += J[i].transpose() * Omega * e;
      for (std::size_t j = 0; j < J.size(); ++j)
        H.block(at, column[vertices[j]], J[i].cols(), J[j].cols()) += J[i].transpose() * Omega * J[j];
    }
  }
  // Eliminates the pose. The Schur complement is the linear system of the neighbors.
  const int rest = size - 3;
  const Eigen::MatrixXd gain = H.bottomLeftCorner(rest, 3) * H.topLeftCorner(3, 3).inverse();
  const Eigen::MatrixXd left_H = H.bottomRightCorner(rest, rest) - gain * H.topRightCorner(3, rest);
  const Eigen::VectorXd left_b = b.tail(rest) - gain * b.head(3);

  graph.remove(pose);  // also removes its edges
  graph.add_edge(DensePrior<SE2, Vector2>::from_information({pose_means, point_means}, left_H, left_b), poses,
                 points);
}
// [/marginalize]

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
    if (lagged_poses.size() > kLag) {
      marginalize(lagged, lagged_poses.front());
      lagged_poses.erase(lagged_poses.begin());
    }
  }

  double largest = 0;
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const Vector2 difference = all.estimate(all_trees[k]) - lagged.estimate(lagged_trees[k]);
    largest = std::max(largest, difference.norm());
  }
  const SE2 apart = all.estimate(all_poses.back()).inverse() * lagged.estimate(lagged_poses.back());
  std::printf("the smoother keeps %zu poses and %zu edges; the full graph has %zu and %zu\n",
              lagged_poses.size(), lagged.edge_count(), all_poses.size(), all.edge_count());
  std::printf("difference from the full graph is below 2 mm: %s for the trees, %s for the last pose\n",
              largest < 0.002 ? "yes" : "no", apart.translation().norm() < 0.002 ? "yes" : "no");
  return largest < 0.002 && apart.translation().norm() < 0.002 ? 0 : 1;
}
