// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/optimize/optimizer.h"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "boxplus/algorithm/algorithm.h"
#include "boxplus/algorithm/algorithm_table.h"
#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

using ::testing::HasSubstr, ::testing::ThrowsMessage;

TEST(Optimizer, ComputesTheSameBitsAsOptimize) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 30);
  Graph copy = graph;
  Optimizer optimizer(graph);
  const Report report = optimizer.run(), expected = optimize(copy);
  EXPECT_TRUE(report.converged());
  EXPECT_EQ(report.chi2_final, expected.chi2_final);
  EXPECT_EQ(report.iterations, expected.iterations);
  EXPECT_EQ(graph.estimate(poses[7]).vector(), copy.estimate(poses[7]).vector());
}

TEST(Optimizer, RefusesToRunAfterItsGraphWasMovedAssignedToOrDestroyed) {
  const auto refused = HasSubstr("its graph was moved, assigned to or destroyed");
  Graph graph;
  add_noisy_circle(graph, 10);
  Optimizer of_moved(graph);
  EXPECT_TRUE(of_moved.run().converged());
  Graph moved = std::move(graph);
  EXPECT_THAT([&] { (void)of_moved.run(); }, ThrowsMessage<InvalidArgument>(refused));
  EXPECT_TRUE(Optimizer(moved).run().converged());

  Optimizer of_assigned(moved);
  moved = Graph();
  EXPECT_THAT([&] { (void)of_assigned.run(); }, ThrowsMessage<InvalidArgument>(refused));

  std::optional<Graph> destroyed(std::in_place);
  const auto poses = add_noisy_circle(*destroyed, 10);
  Optimizer of_destroyed(*destroyed);
  destroyed.reset();
  EXPECT_THAT([&] { (void)of_destroyed.run(); }, ThrowsMessage<InvalidArgument>(refused));
  EXPECT_THAT([&] { (void)of_destroyed.covariance(poses[1], poses[1]); },
              ThrowsMessage<InvalidArgument>(refused));
}

TEST(Optimizer, KeepsItsOptionsAndPlanIfItIsMoved) {
  Graph graph;
  add_noisy_circle(graph, 10);
  Optimizer first(graph, {.max_iterations = 7});
  EXPECT_FALSE(first.run().plan_reused);
  Optimizer second = std::move(first);
  EXPECT_EQ(second.options().max_iterations, 7);
  EXPECT_TRUE(second.run().plan_reused);
}

TEST(Optimizer, ThatWasMovedFromRefusesEveryCall) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 10);
  Optimizer first(graph);
  Optimizer second = std::move(first);
  Report report;
  const auto algorithm = make_algorithm(AlgorithmKind::kGaussNewton);
  const std::vector<std::function<void()>> calls{
      [&] { (void)first.run(); },  // NOLINT(bugprone-use-after-move): what this test is about
      [&] { first.run(report); },
      [&] { (void)first.run(*algorithm); },
      [&] { first.run(*algorithm, report); },
      [&] { (void)first.options(); },
      [&] { first.set_options({}); },
      [&] { (void)first.covariance(poses[1], poses[1]); },
  };
  for (const auto& call : calls)
    EXPECT_THAT(call, ThrowsMessage<InvalidArgument>(HasSubstr("Optimizer: it was moved from")));
  first = std::move(second);
  EXPECT_TRUE(first.run().converged());
}

TEST(Optimizer, MayBeConstructedBeforeTheGraphIsFilled) {
  Graph graph;
  Optimizer optimizer(graph);
  EXPECT_EQ(optimizer.run().reason, Report::Reason::kNothingToOptimize);
  add_noisy_circle(graph, 10);
  EXPECT_GT(optimizer.run().iterations, 0);
}

TEST(Optimizer, RefusesToRunInsideARunOnTheSameGraph) {
  Graph graph;
  add_noisy_circle(graph, 10);
  Optimizer other(graph);
  int calls = 0;
  Options options;
  options.callback = [&](const IterationRecord&) {
    ++calls;
    EXPECT_THAT([&] { (void)other.run(); }, ThrowsMessage<InvalidArgument>(HasSubstr("is being optimized")));
    EXPECT_THAT([&] { (void)optimize(graph); },
                ThrowsMessage<InvalidArgument>(HasSubstr("is being optimized")));
    return true;
  };
  EXPECT_TRUE(Optimizer(graph, options).run().converged());
  EXPECT_GT(calls, 0);
  EXPECT_TRUE(other.run().converged());
}

TEST(Optimizer, RunsAgainAfterAnErrorFunctionThrew) {
  Graph graph;
  const auto x = graph.add_vertex(3.0);
  bool throws = true;
  graph.add_edge(
      [&throws](const double& v) {
        if (throws) throw std::runtime_error("no measurement");
        return v - 1.0;
      },
      x);
  Optimizer optimizer(graph);
  EXPECT_THROW((void)optimizer.run(), std::runtime_error);
  throws = false;
  EXPECT_TRUE(optimizer.run().converged());
  EXPECT_NEAR(graph.estimate(x), 1, 1e-9);
}

TEST(Optimizer, ChecksItsOptionsInEachRun) {
  Graph graph;
  add_noisy_circle(graph, 5);
  Optimizer optimizer(graph);
  optimizer.set_options({.linear_tolerance = 2});
  EXPECT_THAT([&] { (void)optimizer.run(); }, ThrowsMessage<InvalidArgument>(HasSubstr("linear_tolerance")));
  optimizer.set_options({});
  EXPECT_TRUE(optimizer.run().converged());
}

/// Steepest descent for a problem whose Hessian is the identity: each step is the negative gradient times
/// `length`. Fills nothing of the record.
class SteepestDescent final : public Algorithm {
 public:
  explicit SteepestDescent(double length) : length_(length) {}
  std::string_view name() const override { return "steepest descent"; }
  void reset(const Options&, std::size_t scalars) override { step_.assign(scalars, 0); }
  IterationOutcome iterate(System& system, double chi2, IterationRecord& record) override {
    if (!system.linearize()) return IterationOutcome::kNotFinite;
    record.predicted_decrease = chi2;  // of the best step
    for (std::size_t k = 0; k < step_.size(); ++k) {
      step_[k] = -length_ * system.gradient()[k];
    }
    (void)system.try_step(step_);
    system.accept();
    return IterationOutcome::kAccepted;
  }

 private:
  double length_;
  std::vector<double> step_;
};

TEST(Optimizer, RunsACustomAlgorithm) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(5, -2));
  graph.add_edge([](const auto& p) { return p; }, x);
  SteepestDescent algorithm(1);
  const Report report = Optimizer(graph).run(algorithm);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.algorithm, "steepest descent");
  EXPECT_LT(graph.estimate(x).norm(), 1e-12);
}

TEST(Optimizer, IsNotConvergedIfAStepThatIsTooLongEndsAtTheSameChi2) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(5, -2));
  graph.add_edge([](const auto& p) { return p; }, x);
  SteepestDescent algorithm(2);  // reflects x at the minimum
  const Report report = Optimizer(graph).run(algorithm);
  EXPECT_EQ(report.reason, Report::Reason::kMaxIterations) << report;
  EXPECT_EQ(report.chi2_final, 29);
}

TEST(Optimizer, DescribesTheStepsOfACustomAlgorithmByItself) {
  Graph graph;
  const auto x = graph.add_vertex(Vector2(5, -2));
  graph.add_edge([](const auto& p) { return p; }, x);
  SteepestDescent algorithm(0.5);
  const Report report = Optimizer(graph).run(algorithm);
  EXPECT_TRUE(report.converged()) << report;
  ASSERT_GE(report.records.size(), 2u);
  EXPECT_EQ(report.records[0].chi2, 29.0 / 4);
  EXPECT_EQ(report.records[0].chi2_decrease, 29.0 * 3 / 4);
  EXPECT_EQ(report.records[0].gradient_max, 5);
  EXPECT_EQ(report.records[0].step_max, 2.5);
  EXPECT_EQ(report.records[1].gradient_max, 2.5);
  EXPECT_LT(report.chi2_final, 1e-9);
}

}  // namespace
}  // namespace boxplus
