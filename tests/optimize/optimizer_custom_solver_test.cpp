// SPDX-License-Identifier: BSD-3-Clause
// Linear solvers that a user implements.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "boxplus/linear/make_linear_solver.h"
#include "optimize/small_graphs.h"
#include "optimize/table_entries.h"

namespace boxplus {
namespace {

/// Passes each call to the dense solver, and counts the calls.
class CountingSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "counting"; }
  Needs needs() const override { return dense_->needs(); }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) override {
    ++analyses;
    dense_->analyze(structure, hints, stop);
  }
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control) override {
    ++factorizations;
    return dense_->factorize(system, damping, control);
  }
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override {
    return dense_->solve(b, columns, x, control);
  }

  int analyses = 0, factorizations = 0;

 private:
  std::unique_ptr<LinearSolver> dense_ = make_linear_solver(LinearSolverKind::kDense);
};

TEST(CustomLinearSolver, SolvesAllSystemsOfOptimizeAndIsNamedInTheReport) {
  Graph own, library;
  add_noisy_circle(own, 20);
  add_noisy_circle(library, 20);
  const auto solver = std::make_shared<CountingSolver>();
  Options options;
  options.custom_linear_solver = solver;
  const Report report = optimize(own, options);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.linear_solver, "counting");
  EXPECT_GE(solver->factorizations, report.iterations);
  const double chi2 = optimize(library).chi2_final;
  EXPECT_NEAR(report.chi2_final, chi2, 1e-9 * chi2);
}

TEST(CustomLinearSolver, SolvesForSeveralGraphsInTurn) {
  Graph small, large;
  const auto first = add_noisy_circle(small, 10);
  add_noisy_circle(large, 30);
  const auto solver = std::make_shared<CountingSolver>();
  Options options;
  options.custom_linear_solver = solver;
  const double chi2 = optimize(small, options).chi2_final;
  EXPECT_TRUE(optimize(large, options).converged());
  small.set_estimate(first[3], SE2(1, 2, 0.1));
  const Report again = optimize(small, options);
  EXPECT_TRUE(again.converged()) << again;
  EXPECT_NEAR(again.chi2_final, chi2, 1e-8 * chi2);
  EXPECT_EQ(solver->analyses, 3);
  EXPECT_NE(optimize(small).linear_solver, "counting") << "the solver is used only if the options contain it";
}

/// Never succeeds. factorize() or, if `in_solve`, solve() returns the failure.
class FailingSolver final : public LinearSolver {
 public:
  FailingSolver(const FactorResult& failure, bool in_solve) : failure_(failure), in_solve_(in_solve) {}
  std::string_view name() const override { return "failing"; }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure&, const AnalyzeHints&, const StopToken&) override {}
  FactorResult factorize(const BlockSystem&, const Damping&, const SolveControl&) override {
    return in_solve_ ? FactorResult{} : failure_;
  }
  SolveResult solve(const double*, int, double*, const SolveControl&) override {
    return {failure_.status, 0, false, failure_.failed_block, failure_.failed_scalar};
  }

 private:
  FactorResult failure_;
  bool in_solve_;
};

TEST(CustomLinearSolver, IsRefusedIfItNamesABlockOrAScalarThatDoesNotExist) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  constexpr std::uint32_t kBlocks = 19, kScalars = 57;  // of 20 poses, one of which the gauge holds
  for (const bool in_solve : {false, true}) {
    for (const bool eliminates : {false, true}) {
      const auto run = [&](const FactorResult& failure) {
        Graph graph;
        const auto poses = add_noisy_circle(graph, 20);
        if (eliminates) {
          for (std::size_t k = 1; k < poses.size(); k += 2) graph.set_eliminated(poses[k], true);
        }
        Options options;
        options.custom_linear_solver = std::make_shared<FailingSolver>(failure, in_solve);
        return optimize(graph, options);
      };
      EXPECT_THAT(
          [&] {
            std::ignore = run({LinearStatus::kNotPositiveDefinite, kBlocks});
          },
          ThrowsMessage<InvalidArgument>(
              HasSubstr("the linear solver 'failing' returned the failed_block 19: expected")));
      EXPECT_THAT(
          [&] {
            std::ignore = run({LinearStatus::kNotPositiveDefinite, 0, kScalars});
          },
          ThrowsMessage<InvalidArgument>(HasSubstr("returned the failed_scalar 57: expected")));
      EXPECT_EQ(run({LinearStatus::kNotPositiveDefinite, 0, 0}).status, Report::Status::kFailed);
      EXPECT_EQ(run({LinearStatus::kNotPositiveDefinite}).status, Report::Status::kFailed);
    }
  }
}

/// Solves densely, then scales the solution so that its relative residual is as large as the tolerance
/// allows. Returns a default SolveResult, which does not even count iterations.
class RoughSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "rough"; }
  Needs needs() const override { return dense_->needs(); }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints, const StopToken& stop) override {
    dense_->analyze(structure, hints, stop);
    structure_ = &structure;
  }
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control) override {
    factorize_tolerance = control.relative_tolerance;
    return dense_->factorize(system, damping, control);
  }
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override {
    solve_tolerance = control.relative_tolerance;
    dense_->solve(b, columns, x, control);
    for (std::uint32_t i = 0; i < structure_->scalars(); ++i) x[i] *= 1 - control.relative_tolerance;
    return {};
  }

  double factorize_tolerance = 0, solve_tolerance = 0;

 private:
  const BlockStructure* structure_ = nullptr;
  std::unique_ptr<LinearSolver> dense_ = make_linear_solver(LinearSolverKind::kDense);
};

/// A graph of linear errors. Its linear model is exact, so chi2 decreases as predicted, except for rounding.
Graph line_of_numbers() {
  Graph graph;
  auto last = graph.add_vertex(0.0);
  graph.fix(last);
  for (int k = 1; k < 30; ++k) {
    const auto next = graph.add_vertex(0.0);
    graph.add_edge([](const auto& a, const auto& b) { return b - a - 1.5; }, last, next);
    graph.add_edge([k](const auto& b) { return 0.1 * (b - 1.0 * k); }, next);
    last = next;
  }
  return graph;
}

class InexactCustomSolver : public ::testing::TestWithParam<AlgorithmKind> {};

TEST_P(InexactCustomSolver, DecreasesChi2AsPredictedForItsInexactSteps) {
  Graph graph = line_of_numbers();
  const auto solver = std::make_shared<RoughSolver>();
  Options options;
  options.algorithm = GetParam();
  options.custom_linear_solver = solver;
  options.linear_tolerance = 0.3;
  options.noise_tolerance = 0;
  const Report report = optimize(graph, options);
  EXPECT_TRUE(report.converged()) << report;
  ASSERT_GE(report.records.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(report.records[k].predicted_decrease, report.records[k].chi2_decrease,
                1e-6 * report.records[k].chi2_decrease)
        << "iteration " << k;
  }
}

TEST_P(InexactCustomSolver, ReceivesTheToleranceInFactorizeAndInSolve) {
  Graph graph = line_of_numbers();
  const auto solver = std::make_shared<RoughSolver>();
  Options options;
  options.algorithm = GetParam();
  options.custom_linear_solver = solver;
  options.linear_tolerance = 0.01;
  std::ignore = optimize(graph, options);
  EXPECT_EQ(solver->factorize_tolerance, 0.01);
  EXPECT_EQ(solver->solve_tolerance, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Algorithms, InexactCustomSolver, ::testing::ValuesIn(every_algorithm()),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace boxplus
