// SPDX-License-Identifier: BSD-3-Clause
// A robot that drives and edits its graph, for the tests of the Smoother.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "boxplus/incremental/marginalize.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/huber.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {

/// A copy without disabled edges, which cannot join anything.
inline Graph without_disabled_edges(const Graph& graph) {
  Graph copy = graph;
  for (const EdgeRef& edge : graph.all_edges()) {
    if (!graph.is_enabled(edge)) copy.remove(edge);
  }
  return copy;
}

/// The largest difference between the estimates of a graph and those of an optimized copy.
inline double distance_from_batch(const Graph& graph) {
  Graph copy = without_disabled_edges(graph);
  Options options{.max_iterations = 1000, .threads = 1};
  options.noise_tolerance = 0;
  options.cost_tolerance = 1e-16;
  EXPECT_TRUE(optimize(copy, options).converged());
  double largest = 0;
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame mine, batch;
    graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, mine);
    copy.vertex_pools()[vertex.pool]->get_frame(vertex.slot, batch);
    for (std::size_t i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(mine.translation[i] - batch.translation[i]));
    for (std::size_t i = 0; i < 9; ++i)
      largest = std::max(largest, std::abs(mine.rotation[i] - batch.rotation[i]));
  }
  return largest;
}

/// By how much chi2 is above that of an optimized copy, as a fraction.
inline double excess_over_batch(const Graph& graph) {
  Graph copy = without_disabled_edges(graph);
  Options options{.max_iterations = 1000, .cost_tolerance = 1e-16, .threads = 1};
  options.noise_tolerance = 0;
  return graph.chi2() / optimize(copy, options).chi2_final - 1;
}

/// A robot that drives in a circle and measures its motion and, now and then, an old pose. `random` also
/// draws edits of the graph.
class Drive {
 public:
  explicit Drive(unsigned seed) : random_(seed) {
    poses_.push_back(graph.add_vertex(SE2()));
    truth_.push_back(SE2());
  }

  void step() {
    const SE2 motion(1, 0, 0.3);
    truth_.push_back(truth_.back() * motion);
    const SE2 measured = noisy(motion);
    poses_.push_back(graph.add_vertex(graph.estimate(poses_.back()) * measured));
    link(poses_.size() - 2, poses_.size() - 1, measured);
    if (chance(0.3)) close(poses_.size() - 1, pick(poses_.size() - 1));
  }

  void close(std::size_t a, std::size_t b) {
    if (a != b) add_edge(a, b, noisy(truth_[a].inverse() * truth_[b]));
  }

  /// One random edit that may cut the graph apart, but leaves no vertex without an edge.
  void edit() {
    const std::size_t v = pick(poses_.size());
    const auto e = edges_[pick(edges_.size())];
    switch (pick(12)) {
      case 0:
        close(v, pick(poses_.size()));
        break;
      case 1:
        graph.set_information(e, 0.5 + static_cast<double>(pick(100)));
        break;
      case 2:
        graph.set_estimate(poses_[v], graph.estimate(poses_[v]) * SE2(0.2, -0.1, 0.05));
        break;
      case 3:
        if (v > 0) graph.set_fixed(poses_[v], !graph.is_fixed(poses_[v]) && chance(0.3));
        break;
      case 4:  // a part that only a prior of marginalize() anchors would turn slowly
        if (!links_.contains(e) || !graph.is_fixed(poses_[0])) graph.set_enabled(e, chance(0.5));
        break;
      case 5:
        graph.set_measurement(e, Between(noisy(graph.measurement(e).measurement)));
        break;
      case 6:
        graph.set_kernel(e, chance(0.5) ? std::make_shared<Huber>(3.0) : nullptr);
        break;
      case 7:
        remove_edge();
        break;
      case 8:
        forget(v);
        break;
      case 9:
        remove_pose(v);
        break;
      case 10:
        add_late_pose(v);
        break;
      default:
        graph.fix_directions(poses_[v], chance(0.2) ? std::vector<int>{2} : std::vector<int>{});
        break;
    }
  }

  /// Removes a random edge between poses that are not consecutive.
  void remove_edge() {
    const std::size_t k = pick(edges_.size());
    if (links_.contains(edges_[k])) return;
    graph.remove(edges_[k]);
    edges_.erase(edges_.begin() + static_cast<std::ptrdiff_t>(k));
  }

  /// Marginalizes a pose that can move and is not the newest one. A prior measures the place of the graph,
  /// but only to first order. So there are none unless the first pose is fixed.
  void forget(std::size_t v) {
    if (v + 1 == poses_.size() || graph.is_fixed(poses_[v]) || !graph.is_fixed(poses_[0])) return;
    marginalize(graph, {poses_[v]});
    drop(v);
    if (v > 0) link(v - 1, v, noisy(truth_[v - 1].inverse() * truth_[v]));
  }

  /// Removes a pose, and joins the poses before and after it.
  void remove_pose(std::size_t v) {
    if (v == 0 || v + 1 == poses_.size()) return;
    graph.remove(poses_[v]);
    drop(v);
    link(v - 1, v, noisy(truth_[v - 1].inverse() * truth_[v]));
  }

  /// Adds a pose between two old ones.
  void add_late_pose(std::size_t v) {
    if (v == 0) return;
    const SE2 half = noisy(SE2(0.5, 0, 0.15));
    poses_.insert(poses_.begin() + static_cast<std::ptrdiff_t>(v),
                  graph.add_vertex(graph.estimate(poses_[v - 1]) * half));
    truth_.insert(truth_.begin() + static_cast<std::ptrdiff_t>(v), truth_[v - 1] * SE2(0.5, 0, 0.15));
    link(v - 1, v, half);
    link(v, v + 1, noisy(truth_[v].inverse() * truth_[v + 1]));
  }

  std::size_t pick(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  bool chance(double p) { return std::bernoulli_distribution(p)(random_); }
  const std::vector<VertexHandle<SE2>>& poses() const { return poses_; }

  Graph graph;

 private:
  void drop(std::size_t v) {
    poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(v));
    truth_.erase(truth_.begin() + static_cast<std::ptrdiff_t>(v));
    std::erase_if(edges_, [&](EdgeRef edge) { return !graph.contains(edge); });
  }
  SE2 noisy(const SE2& motion) {
    std::normal_distribution<> noise(0, 0.01);
    return motion * SE2(noise(random_), noise(random_), noise(random_));
  }
  void add_edge(std::size_t a, std::size_t b, const SE2& measured) {
    edges_.push_back(graph.add_edge(Between(measured), 1e4, poses_[a], poses_[b]));
  }

  void link(std::size_t a, std::size_t b, const SE2& measured) {
    add_edge(a, b, measured);
    links_.insert(edges_.back());
  }

  std::mt19937 random_;
  std::set<EdgeRef> links_;  // between neighbors; without them, a vertex may have no measurement
  std::vector<VertexHandle<SE2>> poses_;
  std::vector<SE2> truth_;
  std::vector<EdgeHandle<Between<SE2>>> edges_;
};

}  // namespace boxplus
