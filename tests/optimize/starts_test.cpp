// SPDX-License-Identifier: BSD-3-Clause
// Start::kAutomatic keeps the estimates, replaces them by the chordal guess, or tries both.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "boxplus/optimize/optimizer.h"
#include "boxplus/robust/default_width.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

const Options kAutomaticStart{.start = Start::kAutomatic};

double chi2_from_chordal(Graph& graph) {
  return optimize(graph, {.start = Start::kChordal}).chi2_final;
}

/// Checks that the records are those of the iterations from the start to the result, and all of them.
void expect_complete_records(const Report& report) {
  ASSERT_FALSE(report.records.empty());
  EXPECT_EQ(report.iterations, static_cast<int>(report.records.size()));
  double chi2 = report.chi2_start();
  for (std::size_t k = 0; k < report.records.size(); ++k) {
    const IterationRecord& record = report.records[k];
    EXPECT_EQ(record.iteration, static_cast<int>(k + 1));
    EXPECT_NEAR(record.chi2 + record.chi2_decrease, chi2, 1e-12 * chi2);
    chi2 = record.chi2;
  }
  EXPECT_NEAR(chi2, report.chi2_final, 1e-12 * chi2);
}

TEST(AutomaticStart, KeepsTheEstimatesIfTheFirstStepDecreasesChi2AsPredicted) {
  Graph graph;
  add_noisy_grid(graph, 4);
  const Report report = optimize(graph, kAutomaticStart);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.start.used, Start::kCurrent);
  EXPECT_GT(report.start.first_step_kept, 0.75);
  EXPECT_LT(report.start.chi2_guess, 0) << "no guess was needed";
  EXPECT_FALSE(report.start.ran_both);
  EXPECT_EQ(report.start.other_iterations, 0);
  expect_complete_records(report);
}

TEST(AutomaticStart, UsesTheChordalGuessIfTheFirstStepDecreasesChi2LessThanPredicted) {
  Graph graph, other;
  for (Graph* each : {&graph, &other}) {
    int turn = 0;
    for (const auto pose : add_noisy_circle(*each, 60)) each->set_estimate(pose, SE2(0, 0, 2.0 * turn++));
  }
  const Report report = optimize(graph, kAutomaticStart);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.start.used, Start::kChordal);
  EXPECT_GE(report.start.chi2_guess, 0);
  EXPECT_FALSE(std::isnan(report.start.first_step_kept));
  EXPECT_NEAR(report.chi2_final, chi2_from_chordal(other), 1e-9 * report.chi2_final);
  EXPECT_GT(report.start.other_iterations, 0);
  expect_complete_records(report);
}

TEST(AutomaticStart, TriesTheOtherStartTooIfTheFinalChi2IsFarAboveTheNoise) {
  Graph graph;
  add_noisy_grid(graph, 4);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_information(edge, 2500 * 100.0);
  const Report report = optimize(graph, kAutomaticStart);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_TRUE(report.start.ran_both);
  EXPECT_GT(report.start.first_step_kept, 0.75);
  EXPECT_NEAR(report.start.chi2_other_final, report.chi2_final, 1e-6 * report.chi2_final);
  EXPECT_GT(report.start.other_iterations, 0);
  expect_complete_records(report);
}

TEST(AutomaticStart, ContinuesFromItsFirstStepIfNoGuessCanBeMade) {
  Graph graph;  // Rosenbrock's function; the first Gauss-Newton step leaves its valley
  const auto point = graph.add_vertex(Eigen::Vector2d(-1.2, 1));
  graph.add_edge(
      []<class S>(const Eigen::Matrix<S, 2, 1>& p) {
        return Eigen::Matrix<S, 2, 1>(1 - p.x(), 10 * (p.y() - p.x() * p.x()));
      },
      point);
  const Report report = optimize(graph, kAutomaticStart);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_LT(report.start.first_step_kept, 0.75);
  EXPECT_EQ(report.start.used, Start::kCurrent);
  EXPECT_FALSE(report.start.note.empty());
  EXPECT_LT((graph.estimate(point) - Eigen::Vector2d(1, 1)).norm(), 1e-6);
  EXPECT_EQ(report.start.other_iterations, 0);
  expect_complete_records(report);
}

TEST(AutomaticStart, MakesNoGuessIfOnlyOneIterationIsAllowed) {
  Graph graph;
  add_noisy_circle(graph, 30);
  const Report report = optimize(graph, {.start = Start::kAutomatic, .max_iterations = 1});
  EXPECT_EQ(report.iterations, 1);
  EXPECT_TRUE(std::isnan(report.start.first_step_kept));
}

TEST(AutomaticStart, DoesNotCountTheFirstIterationsFromAStartThatIsGivenUp) {
  const auto report_after = [](int iterations) {
    Graph graph = std::move(simulate(World::kTorus, {.poses = 150, .noise = 10}).graph);
    return optimize(graph, {.start = Start::kAutomatic, .max_iterations = iterations});
  };
  const Report one = report_after(1), two = report_after(2);
  EXPECT_EQ(one.start.other_iterations, 0);
  EXPECT_GT(two.start.other_iterations, 0);
  EXPECT_EQ(two.start.used, Start::kChordal);
  EXPECT_EQ(two.iterations, 2);
  EXPECT_LT(two.chi2_final, one.chi2_final);
  expect_complete_records(one);
  expect_complete_records(two);
}

TEST(AutomaticStart, CallsTheCallbackInItsFirstIterationAndStopsIfItReturnsFalse) {
  Graph graph;
  add_noisy_grid(graph, 3);
  int calls = 0;
  Options options = kAutomaticStart;
  options.callback = [&](const IterationRecord&) { return ++calls < 1; };
  const Report report = optimize(graph, options);
  EXPECT_EQ(report.reason, Report::Reason::kCallback);
  EXPECT_EQ(calls, 1);
  EXPECT_LT(report.start.chi2_guess, 0);
}

TEST(AutomaticStart, DoesNotTrustTheFirstStepUnderRobustKernels) {
  Graph graph;
  add_noisy_grid(graph, 4);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Tukey(3.0));
  const Report report = optimize(graph, kAutomaticStart);
  EXPECT_TRUE(std::isnan(report.start.first_step_kept));
  EXPECT_GE(report.start.chi2_guess, 0);
}

TEST(AutomaticStart, LeavesIterationsForTheOtherStartUnderRobustKernels) {
  const auto result_of = [](Start start) {
    Graph graph = std::move(simulate(World::kSphere, {.poses = 1000, .outliers = 0.02}).graph);
    for (const EdgeRef& edge : graph.all_edges()) graph.set_kernel(edge, Huber(default_width(6)));
    return optimize(graph, {.start = start});
  };
  const Report current = result_of(Start::kCurrent), automatic = result_of(Start::kAutomatic);
  EXPECT_TRUE(automatic.start.ran_both);
  // This bound was measured for this graph only. The method does not guarantee it.
  EXPECT_LT(automatic.chi2_final, 1.0001 * current.chi2_final) << automatic;
  EXPECT_LE(automatic.iterations + automatic.start.other_iterations, Options().max_iterations);
  expect_complete_records(automatic);
}

TEST(AutomaticStart, ContinuesIfTheGuessIsNotFinite) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 60);
  int turn = 0;
  for (const auto pose : poses) graph.set_estimate(pose, SE2(10, 0, 2.0 * turn++));
  // The error of this edge is finite at the estimates, but not at the guess.
  graph.add_edge([]<class S>(const BasicSE2<S>& pose) { return S(0.1) * sqrt(pose.x() - S(9)); }, poses[30]);
  const Report report =
      optimize(graph, {.algorithm = AlgorithmKind::kLevenbergMarquardt, .start = Start::kAutomatic});
  EXPECT_NE(report.reason, Report::Reason::kNotFinite) << report;
  EXPECT_LT(report.chi2_final, report.chi2_initial);
}

TEST(AutomaticStart, IsAsGoodAsTheBetterOfTheTwoStartsOnSimulatedGraphs) {
  std::set<Start> used;
  for (const World world : {World::kManhattan, World::kTorus, World::kSphere, World::kCity}) {
    for (const double noise : {0.3, 1.0, 3.0}) {
      for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const SimulationOptions simulation{.poses = 150, .seed = seed, .noise = noise};
        Graph automatic = std::move(simulate(world, simulation).graph);
        Graph current = std::move(simulate(world, simulation).graph);
        Graph chordal = std::move(simulate(world, simulation).graph);
        const Report report = optimize(automatic, kAutomaticStart);
        const double best = std::min(optimize(current).chi2_final, chi2_from_chordal(chordal));
        EXPECT_LE(report.chi2_final, best * (1 + 1e-6)) << report;
        expect_complete_records(report);
        used.insert(report.start.used);
      }
    }
  }
  EXPECT_EQ(used.size(), 2u) << "both starts must be used, or this test checks nothing";
}

/// Four poses with measurements that contradict each other, so that chi2 has several minima.
Graph contradictory_graph() {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int k = 0; k < 4; ++k) poses.push_back(graph.add_vertex(SE2(k, 0, 0)));
  graph.fix(poses[0]);
  const auto add = [&](std::size_t a, std::size_t b, const SE2& measured) {
    graph.add_edge(Between(measured), poses[a], poses[b]);
  };
  add(0, 1, SE2(-2, -1, -2.4));
  add(0, 2, SE2(0, 0, -2.1));
  add(0, 3, SE2(-3, -3, -0.6));
  add(1, 2, SE2(-1, 3, 2.9));
  add(1, 3, SE2(-3, -2, 0.1));
  add(2, 3, SE2(-1, -1, 1.7));
  return graph;
}

TEST(ExplicitStart, IsRemarkedOnIfItEndsAboveTheGivenEstimates) {
  Graph graph = contradictory_graph();
  const Report current = optimize(graph);
  EXPECT_EQ(current.start_remark(), "");
  graph.push();
  const Report odometry = optimize(graph, {.start = Start::kOdometry});
  EXPECT_TRUE(odometry.converged()) << odometry;
  EXPECT_GT(odometry.chi2_final, 1.1 * current.chi2_final);
  EXPECT_NE(odometry.start_remark(), "");
  EXPECT_NE(to_string(odometry).find("the start 'current' is better"), std::string::npos) << odometry;
  graph.pop();
  const Report automatic = optimize(graph, kAutomaticStart);
  EXPECT_EQ(automatic.start_remark(), "") << automatic;
}

TEST(ExplicitStart, IsNotRemarkedOnIfItEndsInTheSameMinimum) {
  Graph graph;
  add_noisy_circle(graph, 20);
  ASSERT_TRUE(optimize(graph).converged());
  EXPECT_EQ(optimize(graph, {.start = Start::kOdometry}).start_remark(), "");
}

}  // namespace
}  // namespace boxplus
