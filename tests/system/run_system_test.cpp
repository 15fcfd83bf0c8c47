// SPDX-License-Identifier: BSD-3-Clause
// Algorithms, starts and reports work with any System of a run.
#include "system/run_system.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "boxplus/algorithm/algorithm_table.h"
#include "boxplus/optimize/optimizer.h"
#include "boxplus/testing/simulate.h"
#include "optimize/fill_report.h"
#include "optimize/starts.h"
#include "system/dense_run_system.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr;

Graph small_world() {
  Graph graph = simulate(World::kManhattan, {.poses = 150, .seed = 3}).graph;
  graph.set_fixed(graph.all_vertices().front(), true);
  return graph;
}

/// Runs as an Optimizer does, on a dense reference.
Report run_dense(Graph& graph, const Options& options) {
  Report report;
  DenseRunSystem system(graph);
  const Stopwatch clock;
  RunStop stop(options, clock.start());
  system.set_stop(stop.now());
  begin_report(report, options);
  const auto algorithm = make_algorithm(options.algorithm);
  report.algorithm = algorithm->name();
  EdgeCounter counter;
  describe_problem(report, graph, system, options, counter);
  report.chi2_initial = report.start.chi2_current = system.chi2();
  Descent descent(graph, system, *algorithm, options, stop, clock, report);
  StartMemory memory;
  const RunResult result = minimize_from_starts(descent, report.start, report.time.start_s, memory);
  report.iterations = static_cast<int>(report.records.size());
  finish_report(report, graph, system, result);
  return report;
}

class AnotherSystem : public testing::TestWithParam<std::tuple<AlgorithmKind, Start>> {};

TEST_P(AnotherSystem, EndsAtTheOptimumOfAnOptimizer) {
  Graph graph = small_world(), copy = graph;
  Options options;
  std::tie(options.algorithm, options.start) = GetParam();
  const Report expected = optimize(copy, options), report = run_dense(graph, options);
  ASSERT_TRUE(expected.converged());
  EXPECT_TRUE(report.converged()) << report.message;
  EXPECT_NEAR(report.chi2_final, expected.chi2_final, 1e-6 * expected.chi2_final);
  EXPECT_EQ(report.iterations, expected.iterations);
  EXPECT_EQ(report.start.used, expected.start.used);
  EXPECT_NEAR(report.start.chi2_guess, expected.start.chi2_guess, 1e-6 * std::abs(expected.start.chi2_guess));
  EXPECT_EQ(report.scalars, expected.scalars);
  EXPECT_EQ(report.degrees_of_freedom, expected.degrees_of_freedom);
  EXPECT_EQ(report.message, expected.message);
  EXPECT_THAT(to_string(report), HasSubstr("dense reference"));
}

INSTANTIATE_TEST_SUITE_P(ByAlgorithmAndStart, AnotherSystem,
                         testing::Combine(testing::Values(AlgorithmKind::kGaussNewton,
                                                          AlgorithmKind::kLevenbergMarquardt,
                                                          AlgorithmKind::kDogleg),
                                          testing::Values(Start::kCurrent, Start::kSpanningTree,
                                                          Start::kChordal, Start::kAutomatic)),
                         [](const auto& parameters) {
                           return std::string(to_string(std::get<0>(parameters.param)).substr(0, 3)) +
                                  "From" + std::to_string(static_cast<int>(std::get<1>(parameters.param)));
                         });

TEST(AnotherSystem, ReportsTheLimitThatStopsIt) {
  Graph graph = small_world();
  Options options;
  options.algorithm = AlgorithmKind::kLevenbergMarquardt;
  options.max_iterations = 2;
  const Report report = run_dense(graph, options);
  EXPECT_EQ(report.reason, Report::Reason::kMaxIterations);
  EXPECT_EQ(report.iterations, 2);
  EXPECT_LT(report.chi2_final, report.chi2_initial);
}

}  // namespace
}  // namespace boxplus
