// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/outliers/outliers.h"

#include <gmock/gmock.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/false_closures.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "outliers/doubts.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

/// An optimized graph with false closures, and the optimum without them.
struct Example {
  explicit Example(Graph clean, const FalseClosureOptions& options) : graph(std::move(clean)) {
    Options start;
    start.start = Start::kAutomatic;
    EXPECT_TRUE(optimize(graph, start).converged());
    optimum = graph;
    for (const EdgeRef& edge : add_false_closures(graph, options)) false_closures.insert(edge);
  }

  /// The largest difference between an estimate and the optimum.
  double displacement() const {
    double largest = 0;
    for (const VertexRef& vertex : graph.all_vertices()) {
      const VertexRef other = *optimum.find_vertex(graph.id(vertex));
      detail::Frame a, b;
      graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, a);
      optimum.vertex_pools()[other.pool]->get_frame(other.slot, b);
      for (std::size_t k = 0; k < 3; ++k)
        largest = std::max(largest, std::abs(a.translation[k] - b.translation[k]));
    }
    return largest;
  }

  Graph graph, optimum;
  std::set<EdgeRef> false_closures;
};

Graph simulated(World world, int poses) {
  return simulate(world, {.poses = poses, .seed = 4}).graph;
}

int wrong_verdicts(const OutlierReport& found, const std::set<EdgeRef>& false_closures) {
  int wrong = 0;
  for (const EdgeVerdict& edge : found.verdicts) {
    const bool is_false = false_closures.count(edge.edge) > 0;
    wrong += edge.verdict != (is_false ? Verdict::kOutlier : Verdict::kInlier);
  }
  return wrong;
}

struct Case {
  World world;
  double fraction;
  int group;
};

class FindOutliersInWorld : public ::testing::TestWithParam<Case> {};

TEST_P(FindOutliersInWorld, FindsTheFalseClosuresAndTheOptimumWithoutThem) {
  const Case& c = GetParam();
  Example example(simulated(c.world, 600), {.fraction = c.fraction, .group = c.group});
  const OutlierReport found = find_outliers(example.graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  EXPECT_LE(wrong_verdicts(found, example.false_closures), 0.01 * static_cast<double>(found.verdicts.size()));
  EXPECT_LT(example.displacement(), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Worlds, FindOutliersInWorld,
                         ::testing::Values(Case{World::kManhattan, 0.1, 1}, Case{World::kManhattan, 0.5, 1},
                                           Case{World::kSphere, 0.5, 1}, Case{World::kSphere, 0.5, 10}));

TEST(FindOutliers, KeepsAllClosuresOfACleanGraphAndFindsItsOptimum) {
  Example example(simulated(World::kSphere, 400), {.fraction = 0});
  const OutlierReport found = find_outliers(example.graph);
  EXPECT_EQ(found.count(Verdict::kInlier), found.verdicts.size());
  EXPECT_LT(example.displacement(), 1e-3);
}

TEST(FindOutliers, FindsHalfOfTheClosuresOfARealGraph) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::string path = std::string(folder == nullptr ? "" : folder) + "/posegraph2d/intel_1728.g2o";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "intel_1728.g2o is not in BOXPLUS_DATA";
  for (const int group : {1, 10}) {
    Example example(read_graph(path).graph, {.fraction = 0.5, .group = group});
    const OutlierReport found = find_outliers(example.graph);
    EXPECT_TRUE(found.report.converged()) << found.report.message;
    EXPECT_LE(wrong_verdicts(found, example.false_closures), 15) << group;
    EXPECT_LT(example.displacement(), 0.05) << group;
  }
}

TEST(FindOutliers, FindsASingleFalseClosureThatBendsARealMap) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  const std::string path = std::string(folder == nullptr ? "" : folder) + "/posegraph2d/M3500.g2o";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "M3500.g2o is not in BOXPLUS_DATA";
  const Graph clean = read_graph(path).graph;
  for (const auto& [from, to] : {std::pair<Id, Id>(2624, 3455), {1186, 2716}, {20, 600}, {2887, 3211}}) {
    Graph graph = clean;
    const EdgeRef lie = graph.add_edge(Between<SE2>(SE2(1, 1, 0.5)), Information(44.72136),
                                       graph.vertex<SE2>(from), graph.vertex<SE2>(to));
    const OutlierReport found = find_outliers(graph);
    EXPECT_EQ(found.edges(Verdict::kOutlier), std::vector<EdgeRef>{lie}) << from;
    EXPECT_NEAR(found.report.chi2_final, 137.912951, 1e-5) << from;
  }
}

TEST(FindOutliers, IsNotConvincedByCopiesOfAFalseClosure) {
  Graph graph = simulated(World::kManhattan, 300);
  std::set<EdgeRef> lies;
  for (int copy = 0; copy < 6; ++copy)
    lies.insert(
        graph.add_edge(Between<SE2>(SE2(30, -20, 0.5)), graph.vertex<SE2>(40), graph.vertex<SE2>(200)));
  const OutlierReport found = find_outliers(graph);
  EXPECT_EQ(wrong_verdicts(found, lies), 0);
  EXPECT_GT(found.noise_scale, 0.1);
}

/// The measured motion between two neighbors of a world, or a false one.
EdgeRef odometry_to(Graph& graph, Id id) {
  for (const EdgeRef& edge : graph.edges(*graph.find_vertex(id))) {
    if (graph.vertices(edge)[0] == *graph.find_vertex(id - 1)) return edge;
  }
  ADD_FAILURE();
  return {};
}

TEST(FindOutliers, FindsASecondOdometryEdgeThatContradictsTheFirst) {
  for (const Id at : {60, 200, 290}) {
    Graph graph = simulated(World::kManhattan, 300);
    const EdgeRef lie = graph.add_edge(Between<SE2>(SE2(-3, 2, 1.5)), Information(1000),
                                       graph.vertex<SE2>(at), graph.vertex<SE2>(at + 1));
    const OutlierReport found = find_outliers(graph);
    EXPECT_TRUE(found.report.converged()) << found.report;
    EXPECT_EQ(found.edges(Verdict::kOutlier), std::vector<EdgeRef>{lie}) << at;
  }
}

TEST(FindOutliers, FindsAnOdometryEdgeThatMostClosuresContradict) {
  Graph graph = simulated(World::kManhattan, 600);
  const EdgeRef truth = odometry_to(graph, 300);
  graph.remove(truth);
  const EdgeRef lie = graph.add_edge(Between<SE2>(SE2(-3, 2, 1.5)), Information(100), graph.vertex<SE2>(299),
                                     graph.vertex<SE2>(300));
  const OutlierReport found = find_outliers(graph);
  EXPECT_TRUE(found.report.converged()) << found.report;
  EXPECT_EQ(found.edges(Verdict::kOutlier), std::vector<EdgeRef>{lie});
}

TEST(FindOutliers, DoubtsAResultForWhichMostClosuresWereRejected) {
  OutlierReport result;
  result.report.status = Report::Status::kConverged;
  result.verdicts.resize(10);
  for (std::size_t k = 0; k < 10; ++k) {
    result.verdicts[k].verdict = k < 6 ? Verdict::kOutlier : Verdict::kInlier;
    result.verdicts[k].weight = k < 6 ? 0 : 1;
  }
  outliers::doubt_if_most_are_rejected(result);
  EXPECT_TRUE(result.report.converged());
  result.verdicts[6].verdict = Verdict::kOutlier;
  result.verdicts[6].weight = 0;
  outliers::doubt_if_most_are_rejected(result);
  EXPECT_EQ(result.report.reason, Report::Reason::kRejectedEdges);
  EXPECT_THAT(result.report.message, HasSubstr("7 of the 10 loop closures were rejected"));
  EXPECT_THAT(result.note, HasSubstr("most loop closures do not fit"));
}

TEST(FindOutliers, ReportsEveryClosureOnceWithItsPosesAndItsWeight) {
  Example example(simulated(World::kManhattan, 300), {.fraction = 0.2});
  const OutlierReport found = find_outliers(example.graph);
  std::set<EdgeRef> judged;
  for (const EdgeVerdict& edge : found.verdicts) {
    judged.insert(edge.edge);
    EXPECT_GT(edge.to, edge.from + 1);
    EXPECT_EQ(edge.weight, edge.verdict == Verdict::kInlier ? 1 : 0);
    EXPECT_DOUBLE_EQ(edge.chi2, example.graph.chi2(edge.edge));
  }
  EXPECT_EQ(judged.size(), found.verdicts.size());
  EXPECT_EQ(found.edges(Verdict::kOutlier).size(), found.count(Verdict::kOutlier));
  EXPECT_EQ(found.report.edges + found.verdicts.size() - found.count(Verdict::kInlier),
            example.graph.edge_count());
}

TEST(FindOutliers, SaysThatThereAreNoClosures) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2());
  graph.add_edge(Between(SE2(1, 0, 0)), a, b);
  const OutlierReport found = find_outliers(graph);
  EXPECT_TRUE(found.verdicts.empty());
  EXPECT_THAT(found.note, HasSubstr("no loop closures"));
}

TEST(FindOutliers, ThrowsIfThereIsNoOdometry) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2()), c = graph.add_vertex(SE2());
  static_cast<void>(b);
  graph.add_edge(Between(SE2(1, 0, 0)), a, c);
  EXPECT_THROW(static_cast<void>(find_outliers(graph)), InvalidArgument);
}

TEST(FindOutliers, ThrowsForOptionsOutOfTheirRanges) {
  Graph graph = simulated(World::kManhattan, 50);
  EXPECT_THROW(static_cast<void>(find_outliers(graph, {.false_alarm = 0})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(find_outliers(graph, {.evidence = 0})), InvalidArgument);
  EXPECT_THROW(static_cast<void>(find_outliers(graph, {.window = 0})), InvalidArgument);
  OutlierOptions options;
  options.options.vertices = {graph.all_vertices()[0]};
  EXPECT_THROW(static_cast<void>(find_outliers(graph, options)), InvalidArgument);
}

/// Removes the odometry between two poses in the middle.
Graph with_gap(Graph graph) {
  const Id middle = static_cast<Id>(graph.vertex_count() / 2);
  const VertexRef before = *graph.find_vertex(middle), after = *graph.find_vertex(middle + 1);
  for (const EdgeRef& edge : graph.edges(before)) {
    const std::vector<VertexRef> ends = graph.vertices(edge);
    if (ends[0] == after || ends[1] == after) graph.remove(edge);
  }
  return graph;
}

TEST(FindOutliers, BridgesAGapInTheOdometryByClosuresThatAgree) {
  Example example(with_gap(simulated(World::kSphere, 600)), {.fraction = 0.3});
  const OutlierReport found = find_outliers(example.graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  EXPECT_EQ(found.note, "");
  EXPECT_LE(wrong_verdicts(found, example.false_closures), 0.01 * static_cast<double>(found.verdicts.size()));
  EXPECT_LT(example.displacement(), 0.05);
}

TEST(FindOutliers, SaysThatAGapIsBridgedByAClosureThatCannotBeJudged) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 6; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
  for (const std::size_t k : {0u, 1u, 3u, 4u}) graph.add_edge(Between(SE2(1, 0, 0)), poses[k], poses[k + 1]);
  const EdgeRef bridge = graph.add_edge(Between(SE2(2, 0, 0)), poses[1], poses[3]);
  const OutlierReport found = find_outliers(graph);
  ASSERT_EQ(found.verdicts.size(), 1u);
  EXPECT_EQ(found.verdicts[0].edge, bridge);
  EXPECT_EQ(found.verdicts[0].verdict, Verdict::kUndecided);
  EXPECT_EQ(found.verdicts[0].weight, 1);
  EXPECT_THAT(found.note, HasSubstr("1 gap in the odometry"));
}

TEST(FindOutliers, JudgesNoClosureIfItIsStopped) {
  Example example(simulated(World::kManhattan, 300), {.fraction = 0.3});
  const std::atomic<bool> stop = true;
  OutlierOptions options;
  options.options.stop = &stop;
  const OutlierReport found = find_outliers(example.graph, options);
  EXPECT_FALSE(found.report.converged());
  EXPECT_EQ(found.count(Verdict::kUndecided), found.verdicts.size());
  EXPECT_THAT(found.note, HasSubstr("stopped"));
}

TEST(FindOutliers, FindsTheSameBitsWithAnyNumberOfThreads) {
  const Example example(simulated(World::kSphere, 600), {.fraction = 0.5});
  double chi2[2];
  for (const int threads : {1, 2}) {
    Graph graph = example.graph;
    OutlierOptions options;
    options.options.threads = threads;
    chi2[threads - 1] = find_outliers(graph, options).report.chi2_final;
  }
  EXPECT_EQ(chi2[0], chi2[1]);
}

TEST(FindOutliers, KeepsObservationsOfLandmarks) {
  Graph clean = simulated(World::kManhattan, 300);
  const auto landmark = clean.add_vertex(Vector2(3, 4));
  for (const Id id : {10, 20, 30}) {
    const auto pose = clean.vertex<SE2>(id);
    clean.add_edge(PointObservation2(clean.estimate(pose).inverse_times(Vector2(3, 4))), 0.01, pose,
                   landmark);
  }
  Example example(std::move(clean), {.fraction = 0.3});
  const OutlierReport found = find_outliers(example.graph);
  EXPECT_TRUE(found.report.converged()) << found.report.message;
  EXPECT_LE(wrong_verdicts(found, example.false_closures), 0.02 * static_cast<double>(found.verdicts.size()));
  EXPECT_EQ(found.report.edges + found.verdicts.size() - found.count(Verdict::kInlier),
            example.graph.edge_count());
}

TEST(FindOutliers, UsesTheFirstRunOfACleanGraphWithManyLandmarks) {
  Graph clean = simulated(World::kManhattan, 100);
  Graph truth = clean;
  EXPECT_TRUE(optimize(truth, {.start = Start::kAutomatic}).converged());
  for (int k = 0; k < 40; ++k) {
    const auto landmark = clean.add_vertex(Vector2(0, 0));
    for (Id id = 0; id < 100; id += 2) {
      const Vector2 seen = truth.estimate(truth.vertex<SE2>(id)).inverse_times(Vector2(k, -k));
      const Vector2 error(0.1 * std::sin(double(id)), 0.1 * std::cos(3.0 * double(id) + k));
      clean.add_edge(PointObservation2(Vector2(seen + error)), Information(100), clean.vertex<SE2>(id),
                     landmark);
    }
  }
  const OutlierReport found = find_outliers(clean);
  EXPECT_EQ(found.count(Verdict::kInlier), found.verdicts.size());
  EXPECT_GT(found.report.iterations, 1) << "the run with all closures, not one that begins at its result";
}

TEST(FindOutliers, RefusesPosesInThePlaneAndInSpaceUnlessAllEdgesAreSuspects) {
  Graph graph = simulated(World::kManhattan, 100);
  auto last = graph.add_vertex(SE3());
  for (int k = 0; k < 5; ++k) {
    const auto next = graph.add_vertex(SE3());
    graph.add_edge(Between<SE3>(SE3()), last, next);
    last = next;
  }
  EXPECT_THROW(static_cast<void>(find_outliers(graph)), InvalidArgument);
  OutlierOptions options;
  options.suspects = Suspects::kAll;
  EXPECT_EQ(find_outliers(graph, options).verdicts.size(), graph.edge_count());
}

}  // namespace
}  // namespace boxplus
