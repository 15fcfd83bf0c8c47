// SPDX-License-Identifier: BSD-3-Clause
// find_outliers() if all edges are suspects.
#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <random>
#include <set>

#include "boxplus/base/error.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/testing/simulate_bundle.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "outliers/annealing.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

OutlierReport find_all(Graph& graph) {
  OutlierOptions options;
  options.suspects = Suspects::kAll;
  return find_outliers(graph, options);
}

std::set<EdgeRef> of_kind(const Simulation& world, EdgeKind kind) {
  std::set<EdgeRef> edges;
  for (std::size_t k = 0; k < world.edges.size(); ++k) {
    if (world.kinds[k] == kind) edges.insert(world.edges[k]);
  }
  return edges;
}

/// The numbers of verdicts, by whether the edge is false.
struct Counts {
  int found = 0, missed = 0, accused = 0, undecided = 0;

  Counts(const OutlierReport& report, const std::set<EdgeRef>& false_edges) {
    for (const EdgeVerdict& edge : report.verdicts) {
      const bool is_false = false_edges.count(edge.edge) > 0;
      undecided += edge.verdict == Verdict::kUndecided;
      if (edge.verdict == Verdict::kOutlier) ++(is_false ? found : accused);
      missed += edge.verdict == Verdict::kInlier && is_false;
    }
  }
};

TEST(AnnealedWeight, FallsFromOneToZeroBetweenTheTwoLimitsOfItsParameter) {
  constexpr double kC2 = 8;
  for (const double mu : {1e-6, 0.1, 1.0, 50.0}) {
    const double lower = kC2 * mu / (mu + 1), upper = kC2 * (mu + 1) / mu;
    EXPECT_EQ(outliers::annealed_weight(0.999 * lower, kC2, mu), 1);
    EXPECT_NEAR(outliers::annealed_weight(1.000001 * lower, kC2, mu), 1, 1e-4);
    EXPECT_NEAR(outliers::annealed_weight(0.999999 * upper, kC2, mu), 0, 1e-4);
    EXPECT_EQ(outliers::annealed_weight(1.001 * upper, kC2, mu), 0);
  }
  EXPECT_DOUBLE_EQ(outliers::annealed_weight(8, kC2, 1), std::sqrt(2.0) - 1);
  EXPECT_EQ(outliers::annealed_weight(std::nan(""), kC2, 1), 0);
}

TEST(FindAllOutliers, FindsFalseObservationsOfLandmarks) {
  Simulation world = simulate(World::kCity, {.poses = 800, .seed = 3, .outliers = 0.2});
  const std::set<EdgeRef> false_edges = of_kind(world, EdgeKind::kOutlier);
  ASSERT_GT(false_edges.size(), 300u);
  const OutlierReport found = find_all(world.graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  EXPECT_EQ(found.verdicts.size(), world.graph.edge_count());
  const Counts counts(found, false_edges);
  EXPECT_GE(counts.found, 0.98 * static_cast<double>(false_edges.size()));
  EXPECT_LE(counts.accused, 4);
  EXPECT_NEAR(found.noise_scale, 0.6, 0.3);
}

TEST(FindAllOutliers, FindsFalseObservationsInBundleAdjustment) {
  BundleSimulation world =
      simulate_bundle(BundleShape::kStreet, {.cameras = 20, .points = 1000, .seed = 2, .outliers = 0.1});
  std::set<EdgeRef> false_edges;
  const std::vector<EdgeRef> edges = world.graph.all_edges();
  for (std::size_t k = 0; k < edges.size(); ++k) {
    if (world.is_outlier[k]) false_edges.insert(edges[k]);
  }
  const OutlierReport found = find_all(world.graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  EXPECT_NEAR(found.report.chi2_per_degree(), 1, 0.1);
  const Counts counts(found, false_edges);
  EXPECT_LE(counts.accused, 0.03 * counts.found);
  EXPECT_LE(counts.missed, 0.03 * counts.found);
}

TEST(FindAllOutliers, RegistersTwoCloudsIfHalfOfThePairsAreFalse) {
  Graph graph;
  const SE3 truth(Vector3(1, -2, 0.5), detail::Quaternion<double>{0.2, -0.4, 0.4, 0.8});
  const auto pose = graph.add_vertex(SE3());
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-5, 5);
  std::normal_distribution<double> noise(0, 0.01);
  std::set<EdgeRef> false_edges;
  for (int k = 0; k < 100; ++k) {
    const Vector3 point(uniform(random), uniform(random), uniform(random));
    const auto vertex = graph.add_vertex(point);
    graph.fix(vertex);
    Vector3 seen = truth.inverse() * point;
    for (int row = 0; row < 3; ++row) seen[row] = k % 5 < 2 ? uniform(random) : seen[row] + noise(random);
    const EdgeRef edge = graph.add_edge(PointObservation3(seen), 1e4, pose, vertex);
    if (k % 5 < 2) false_edges.insert(edge);
  }
  const OutlierReport found = find_all(graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  const Counts counts(found, false_edges);
  EXPECT_EQ(counts.found, 40);
  EXPECT_EQ(counts.accused, 0);
  EXPECT_LT((graph.estimate(pose).translation() - truth.translation()).norm(), 0.01);
}

TEST(FindAllOutliers, FindsFalseOdometryBesidesFalseClosures) {
  Simulation world = simulate(World::kSphere, {.poses = 400, .seed = 4, .outliers = 0.1});
  Graph& graph = world.graph;
  std::set<EdgeRef> false_edges = of_kind(world, EdgeKind::kOutlier);
  const std::set<EdgeRef> odometry = of_kind(world, EdgeKind::kOdometry);
  std::size_t k = 0;
  for (const EdgeRef& edge : odometry) {
    if (k++ % 50 != 7) continue;
    const EdgeHandle<Between<SE3>> handle{edge};
    const SE3 turn(Vector3(3, 0, -4), detail::Quaternion<double>{0, 0, 0.6, 0.8});
    graph.set_measurement(handle, Between(graph.measurement(handle).measurement * turn));
    false_edges.insert(edge);
  }
  const OutlierReport found = find_all(graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  const Counts counts(found, false_edges);
  EXPECT_EQ(counts.found, static_cast<int>(false_edges.size()));
  EXPECT_EQ(counts.accused, 0);
}

TEST(FindAllOutliers, AcceptsAllEdgesOfACleanGraphAndKeepsKernelsAndFlags) {
  Graph graph = simulate(World::kManhattan, {.poses = 300, .seed = 4}).graph;
  const std::vector<EdgeRef> edges = graph.all_edges();
  graph.set_kernel(edges[3], Huber(1e6));
  graph.set_enabled(edges[5], false);
  Graph optimum = graph;
  static_cast<void>(optimize(optimum));
  const OutlierReport found = find_all(graph);
  EXPECT_EQ(found.count(Verdict::kOutlier), 0u);
  EXPECT_EQ(found.verdicts.size(), edges.size() - 1);
  EXPECT_NEAR(graph.chi2(), optimum.chi2(), 1e-4 * optimum.chi2());
  for (const EdgeRef& edge : edges) {
    EXPECT_EQ(graph.is_enabled(edge), edge != edges[5]);
    EXPECT_EQ(graph.kernel(edge) != nullptr, edge == edges[3]);
  }
  EXPECT_EQ(graph.kernel(edges[3])->delta(), 1e6);
}

TEST(FindAllOutliers, LeavesEdgesUndecidedThatFitWhateverTheyMeasure) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 6; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
  graph.fix(poses[0]);
  for (std::size_t k = 0; k < 5; ++k) graph.add_edge(Between(SE2(1, 0.1, 0)), poses[k], poses[k + 1]);
  graph.add_edge(Between(SE2(3, 0, 0)), poses[0], poses[3]);
  const OutlierReport found = find_all(graph);
  for (const EdgeVerdict& edge : found.verdicts) {
    EXPECT_EQ(edge.verdict, edge.to > 3 ? Verdict::kUndecided : Verdict::kInlier) << edge.from;
    EXPECT_EQ(edge.weight, 1);
  }
}

TEST(FindAllOutliers, IsNotConvergedIfMostEdgesAreRejected) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(0, 0));
  for (int k = 0; k < 4; ++k) graph.add_edge(Prior(Vector2(0.01 * k, 0)), 100, point);
  for (int k = 0; k < 6; ++k)
    graph.add_edge(Prior(Vector2(100 * std::cos(k), 70 * std::sin(2 * k + 1))), 100, point);
  const OutlierReport found = find_all(graph);
  EXPECT_EQ(found.count(Verdict::kOutlier), 6u);
  EXPECT_FALSE(found.report.converged());
  EXPECT_EQ(found.report.reason, Report::Reason::kRejectedEdges);
  EXPECT_THAT(found.note, HasSubstr("more than half"));
}

TEST(FindAllOutliers, AcceptsAllEdgesIfEveryInformationIsTooLargeByTheSameFactor) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(0, 0));
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  for (int k = 0; k < 50; ++k) graph.add_edge(Prior(Vector2(noise(random), noise(random))), 1e6, point);
  const OutlierReport found = find_all(graph);
  EXPECT_EQ(found.count(Verdict::kInlier), 50u);
  EXPECT_NEAR(found.noise_scale, 1e6, 5e5);
  EXPECT_THAT(found.note, HasSubstr("times as large as Ω says"));
}

TEST(FindAllOutliers, FindsAFalseEdgeAmongThree) {
  Graph graph;
  const auto point = graph.add_vertex(Vector2(0, 0));
  for (const double x : {1.0, 1.0, 5.0}) graph.add_edge(Prior(Vector2(x, 0)), 100, point);
  const OutlierReport found = find_all(graph);
  ASSERT_EQ(found.count(Verdict::kOutlier), 1u);
  EXPECT_EQ(found.verdicts[2].verdict, Verdict::kOutlier);
  EXPECT_NEAR(graph.estimate(point)[0], 1, 1e-9);
}

/// The difference between a sample and the line through it.
struct Sample {
  double x, y;
  template <class S>
  S error(const Vector<S, 2>& line) const {
    return line[0] * x + line[1] - y;
  }
};

TEST(FindAllOutliers, FindsOneSidedOutliersOfALine) {
  Graph graph;
  const auto line = graph.add_vertex(Vector2(0, 0));
  std::mt19937 random(2);
  std::normal_distribution<double> noise(0, 0.1);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::set<EdgeRef> false_edges;
  for (int k = 0; k < 200; ++k) {
    const bool is_false = k % 10 < 3;
    const double x = uniform(random),
                 y = 3 * x + 1 + noise(random) + (is_false ? 2 + 8 * uniform(random) : 0);
    const EdgeRef edge = graph.add_edge(Sample{x, y}, 100, line);
    if (is_false) false_edges.insert(edge);
  }
  const OutlierReport found = find_all(graph);
  const Counts counts(found, false_edges);
  EXPECT_EQ(counts.found, 60);
  EXPECT_EQ(counts.accused, 0);
  EXPECT_NEAR(found.noise_scale, 1, 0.4);
}

TEST(FindAllOutliers, JudgesNoEdgeIfItsTimeIsUp) {
  Graph graph = simulate(World::kManhattan, {.poses = 300, .seed = 4, .outliers = 0.2}).graph;
  OutlierOptions options;
  options.suspects = Suspects::kAll;
  options.options.time_limit_s = 0;
  const OutlierReport found = find_outliers(graph, options);
  EXPECT_FALSE(found.report.converged());
  EXPECT_EQ(found.count(Verdict::kUndecided), found.verdicts.size());
  EXPECT_THAT(found.note, HasSubstr("stopped"));
}

TEST(FindAllOutliers, JudgesNoEdgeIfItIsStopped) {
  Graph graph = simulate(World::kManhattan, {.poses = 300, .seed = 4, .outliers = 0.2}).graph;
  const std::atomic<bool> stop = true;
  OutlierOptions options;
  options.suspects = Suspects::kAll;
  options.options.stop = &stop;
  const OutlierReport found = find_outliers(graph, options);
  EXPECT_FALSE(found.report.converged());
  EXPECT_EQ(found.count(Verdict::kUndecided), found.verdicts.size());
  EXPECT_THAT(found.note, HasSubstr("stopped"));
}

}  // namespace
}  // namespace boxplus
