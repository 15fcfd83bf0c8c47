// SPDX-License-Identifier: BSD-3-Clause
// When a graph grows, shrinks or changes, its Optimizer finds the same optimum as for an equal new graph.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <tuple>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

/// The poses of a random drive, which see each other and points. Each step adds, removes or fixes vertices
/// and edges at random.
class World {
 public:
  World(unsigned seed, bool fix_first) : random_(seed) {
    poses_.push_back(graph.add_vertex(SE2(), next_id_++));
    if (fix_first) graph.fix(poses_[0]);
    for (int k = 0; k < 8; ++k) drive();
  }

  void step() {
    const unsigned dice = random_() % 20;
    drive();
    if (dice < 8) close();
    if (dice % 4 == 0) see_point();
    if (dice == 1) remove_closure();
    if (dice == 2)
      graph.remove(poses_[poses_.size() / 2]),
          poses_.erase(poses_.begin() + static_cast<long>(poses_.size() / 2));
    if (dice == 3) graph.set_fixed(poses_[poses_.size() / 3], !graph.is_fixed(poses_[poses_.size() / 3]));
    if (dice == 4) graph.add_edge(Prior(graph.estimate(poses_.back())), 10.0, poses_.back());
  }

  /// The same vertices and edges in a new graph, with the current estimates.
  Graph copy() const {
    Graph result;
    for (const VertexRef& v : graph.all_vertices()) {
      VertexRef added;
      if (is_pose(v)) {
        added = result.add_vertex(graph.estimate(graph.typed<SE2>(v)), graph.id(v));
      } else {
        added = result.add_vertex(graph.estimate(graph.typed<Vector2>(v)), graph.id(v));
      }
      result.set_fixed(added, graph.is_fixed(v));
    }
    for (const EdgeRef& e : graph.all_edges()) add_copy(result, e);
    return result;
  }

  std::vector<double> estimates() const {
    std::vector<double> all;
    for (const VertexRef& v : graph.all_vertices()) {
      if (!is_pose(v)) continue;
      const auto x = graph.estimate(graph.typed<SE2>(v)).vector();
      all.insert(all.end(), x.data(), x.data() + 3);
    }
    return all;
  }

  Graph graph;

 private:
  double noise() { return std::normal_distribution<>(0, 0.02)(random_); }
  SE2 noisy(const SE2& motion) { return motion * SE2(noise(), noise(), noise()); }
  bool is_pose(const VertexRef& v) const { return v.pool == poses_[0].pool; }

  void drive() {
    const auto last = poses_.back();
    const SE2 motion(1, 0, std::uniform_real_distribution<>(-0.3, 0.3)(random_));
    poses_.push_back(graph.add_vertex(graph.estimate(last) * noisy(motion), next_id_++));
    graph.add_edge(Between(motion), 100.0, last, poses_.back());
    // Because of this second edge, the chain stays connected if a pose is removed.
    if (poses_.size() > 3) measure(poses_[poses_.size() - 3], poses_.back());
  }
  EdgeRef measure(VertexHandle<SE2> a, VertexHandle<SE2> b) {
    return graph.add_edge(Between(noisy(graph.estimate(a).inverse_times(graph.estimate(b)))), 50.0, a, b);
  }
  void close() {
    const std::size_t a = random_() % (poses_.size() - 2),
                      b = random_() % 3 == 0 ? (a + 2) : poses_.size() - 1;
    closures_.push_back(measure(poses_[a], poses_[b]));
  }
  void see_point() {
    if (points_.empty() || random_() % 2 == 0)
      points_.push_back(graph.add_vertex(graph.estimate(poses_.back()) * Vector2(1, 1), next_id_++));
    const auto point = points_.back();
    const Vector2 seen = graph.estimate(poses_.back()).inverse() * graph.estimate(point);
    graph.add_edge(PointObservation2{Vector2(seen[0] + noise(), seen[1] + noise())}, 80.0, poses_.back(),
                   point);
  }
  void remove_closure() {
    if (closures_.empty()) return;
    if (graph.contains(closures_.back())) graph.remove(closures_.back());
    closures_.pop_back();
  }

  void add_copy(Graph& result, const EdgeRef& e) const {
    const auto vertices = graph.vertices(e);
    const auto pose = [&](std::size_t k) { return result.vertex<SE2>(graph.id(vertices[k])); };
    const Information omega(graph.information(e)(0, 0));
    if (vertices.size() == 1) {
      result.add_edge(graph.measurement(EdgeHandle<Prior<SE2>>{e}), omega, pose(0));
    } else if (is_pose(vertices[1])) {
      result.add_edge(graph.measurement(EdgeHandle<Between<SE2>>{e}), omega, pose(0), pose(1));
    } else {
      result.add_edge(graph.measurement(EdgeHandle<PointObservation2>{e}), omega, pose(0),
                      result.vertex<Vector2>(graph.id(vertices[1])));
    }
  }

  std::mt19937 random_;
  Id next_id_ = 0;
  std::vector<VertexHandle<SE2>> poses_;
  std::vector<VertexHandle<Vector2>> points_;
  std::vector<EdgeRef> closures_;
};

TEST(GrowingGraph, HasTheSameOptimumAsANewGraphAfterVerticesWereAddedRemovedOrFixed) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    World world(seed, seed % 2 == 0);
    Optimizer optimizer(world.graph);
    for (int step = 0; step < 60; ++step) {
      world.step();
      Graph fresh = world.copy();
      const Report expected = optimize(fresh), report = optimizer.run();
      ASSERT_TRUE(report.converged()) << report;
      ASSERT_NEAR(report.chi2_initial, expected.chi2_initial, 1e-11 * (1 + expected.chi2_initial));
      ASSERT_NEAR(report.chi2_final, expected.chi2_final, 1e-8 * (1 + expected.chi2_final))
          << report << expected;
      ASSERT_EQ(report.gauge.held, expected.gauge.held);
      ASSERT_EQ(report.scalars, expected.scalars);
      ASSERT_EQ(report.edges, expected.edges);
    }
  }
}

TEST(GrowingGraph, HasTheSameBitsForAnyNumberOfThreads) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    std::array<World, 3> worlds{World(seed, true), World(seed, true), World(seed, true)};
    std::vector<Optimizer> optimizers;
    for (int threads = 1; threads <= 3; ++threads)
      optimizers.emplace_back(worlds[static_cast<std::size_t>(threads - 1)].graph,
                              Options{.max_iterations = 2, .threads = threads});
    for (int step = 0; step < 80; ++step) {
      for (int threads = 1; threads <= 3; ++threads) {
        const auto index = static_cast<std::size_t>(threads - 1);
        worlds[index].step();
        std::ignore = optimizers[index].run();
      }
      ASSERT_EQ(worlds[0].estimates(), worlds[1].estimates());
      ASSERT_EQ(worlds[0].estimates(), worlds[2].estimates());
    }
  }
}

TEST(GrowingGraph, ReportsWhetherItsPlanWasReused) {
  World world(1, true);
  Optimizer optimizer(world.graph);
  EXPECT_FALSE(optimizer.run().plan_reused);
  EXPECT_TRUE(optimizer.run().plan_reused);
  const auto last = world.graph.all_vertices().back();
  const auto next = world.graph.add_vertex(SE2());
  world.graph.add_edge(Between(SE2(1, 0, 0)), 100.0, world.graph.typed<SE2>(last), next);
  EXPECT_FALSE(optimizer.run().plan_reused);
  world.graph.fix(next);
  EXPECT_FALSE(optimizer.run().plan_reused);
}

}  // namespace
}  // namespace boxplus
