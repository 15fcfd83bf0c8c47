// SPDX-License-Identifier: BSD-3-Clause
// The second run of an Optimizer on a graph whose structure did not change.
#include <gtest/gtest.h>

#include <atomic>
#include <type_traits>

#include "allocation_counter.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

class SecondRun : public ::testing::TestWithParam<int> {};

TEST_P(SecondRun, AllocatesNothing) {
  if (!boxplus::testing::allocations_are_counted())
    GTEST_SKIP() << "the sanitizer has an allocator of its own";
  for (const AlgorithmKind algorithm : every_algorithm()) {
    Graph graph;
    const auto poses = add_noisy_grid(graph, 9);
    add_noisy_circle(graph, 100);
    graph.set_kernel(graph.all_edges()[3], Huber(1.0));
    Options options;
    options.algorithm = algorithm;
    options.threads = GetParam();
    Optimizer optimizer(graph, options);
    Report report;
    optimizer.run(report);
    ASSERT_TRUE(report.converged()) << report;
    ASSERT_EQ(report.workers, GetParam());
    const double chi2 = report.chi2_final;
    for (const auto& pose : poses) {
      const double delta[6] = {0.01, -0.02, 0.01, 0.01, -0.01, 0.005};
      graph.set_estimate(pose, Manifold<SE3>::oplus(graph.estimate(pose), delta));
    }
    const long before = boxplus::testing::allocation_count();
    optimizer.run(report);
    EXPECT_EQ(boxplus::testing::allocation_count() - before, 0);
    EXPECT_TRUE(report.plan_reused);
    EXPECT_GT(report.iterations, 1);
    EXPECT_NEAR(report.chi2_final, chi2, 1e-8 * chi2);
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, SecondRun, ::testing::Values(1, 2), ::testing::PrintToStringParamName());

/// A circle of poses. The error function of one edge can raise the stop flag.
struct StoppableCircle {
  Graph graph;
  std::atomic<bool> stop = false;
  bool stops = true;

  StoppableCircle() {
    const auto poses = add_noisy_circle(graph, 50);
    const auto looks = [this]<class Pose>(const Pose& pose) {
      if constexpr (!std::is_same_v<Pose, SE2>) stop = stops;  // called with dual numbers
      return pose.x() - 1.0;
    };
    graph.add_edge(looks, poses[7]);
  }
};

TEST(SecondRunWithNumericJacobians, AllocatesNothing) {
  if (!boxplus::testing::allocations_are_counted())
    GTEST_SKIP() << "the sanitizer has an allocator of its own";
  Graph graph;
  const auto poses = add_noisy_grid(graph, 4);
  Optimizer optimizer(graph, {.numeric_jacobians = true, .threads = 2});
  Report report;
  optimizer.run(report);
  graph.set_estimate(poses[3], graph.estimate(poses[4]));
  const long before = boxplus::testing::allocation_count();
  optimizer.run(report);
  EXPECT_EQ(boxplus::testing::allocation_count() - before, 0);
  EXPECT_GT(report.iterations, 1);
  EXPECT_TRUE(report.converged());
}

TEST(SecondRunAfterAStoppedRun, AllocatesNothing) {
  if (!boxplus::testing::allocations_are_counted())
    GTEST_SKIP() << "the sanitizer has an allocator of its own";
  for (const AlgorithmKind algorithm : every_algorithm()) {
    StoppableCircle circle;
    Options options{.algorithm = algorithm, .max_iterations = 0, .stop = &circle.stop};
    Optimizer optimizer(circle.graph, options);
    Report report;
    circle.stops = false;
    optimizer.run(report);  // makes the plan
    circle.stops = true;
    options.max_iterations = 100;
    optimizer.set_options(options);
    optimizer.run(report);
    ASSERT_EQ(report.reason, Report::Reason::kStopFlag);
    ASSERT_EQ(report.iterations, 0);
    circle.stop = circle.stops = false;
    const long before = boxplus::testing::allocation_count();
    optimizer.run(report);
    EXPECT_EQ(boxplus::testing::allocation_count() - before, 0);
    EXPECT_TRUE(report.plan_reused);
    EXPECT_TRUE(report.converged()) << report;
  }
}

TEST(SecondRunThatIsStopped, AllocatesNothing) {
  if (!boxplus::testing::allocations_are_counted())
    GTEST_SKIP() << "the sanitizer has an allocator of its own";
  StoppableCircle circle;
  circle.stops = false;
  Options options{.stop = &circle.stop};
  Optimizer optimizer(circle.graph, options);
  Report report;
  optimizer.run(report);
  ASSERT_TRUE(report.converged()) << report;
  for (const double limit : {0.0, 1e9}) {
    options.time_limit_s = limit;
    optimizer.set_options(options);
    circle.stops = true;
    const long before = boxplus::testing::allocation_count();
    optimizer.run(report);
    EXPECT_EQ(boxplus::testing::allocation_count() - before, 0);
    EXPECT_EQ(report.reason, limit == 0 ? Report::Reason::kTimeLimit : Report::Reason::kStopFlag);
  }
}

TEST(SecondRunAfterAChange, MakesANewPlan) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 20);
  Optimizer optimizer(graph);
  EXPECT_FALSE(optimizer.run().plan_reused);
  EXPECT_TRUE(optimizer.run().plan_reused);
  const auto edge = graph.add_edge(Between(SE2(1, 0, 0)), poses[3], poses[9]);
  EXPECT_FALSE(optimizer.run().plan_reused);
  graph.remove(edge);
  EXPECT_FALSE(optimizer.run().plan_reused);
  graph.fix(poses[2]);
  EXPECT_FALSE(optimizer.run().plan_reused);
  graph.remove(poses[7]);
  const Report report = optimizer.run();
  EXPECT_FALSE(report.plan_reused);
  EXPECT_TRUE(report.converged()) << report;
  optimizer.set_options({.linear_solver = LinearSolverKind::kPcg});
  EXPECT_FALSE(optimizer.run().plan_reused);
  graph.clear();
  EXPECT_EQ(optimizer.run().reason, Report::Reason::kNothingToOptimize);
}

TEST(SecondRunByAnotherAlgorithm, KeepsThePlan) {
  Graph graph;
  add_noisy_circle(graph, 20);
  Optimizer optimizer(graph);
  for (const AlgorithmKind algorithm :
       {AlgorithmKind::kAutomatic, AlgorithmKind::kGaussNewton, AlgorithmKind::kLevenbergMarquardt}) {
    optimizer.set_options({.algorithm = algorithm});
    const Report report = optimizer.run();
    EXPECT_TRUE(report.converged()) << report;
    EXPECT_EQ(report.plan_reused, algorithm != AlgorithmKind::kAutomatic);
  }
}

}  // namespace
}  // namespace boxplus
