// SPDX-License-Identifier: BSD-3-Clause
// A linear solver that the library does not know.
#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

/// Hands everything on to the dense solver, and counts.
class CountingSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "counting"; }
  Needs needs() const override { return dense_->needs(); }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints) override {
    ++analyses;
    dense_->analyze(structure, hints);
  }
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         std::span<const std::uint32_t> changed_columns) override {
    ++factorisations;
    return dense_->factorize(system, damping, changed_columns);
  }
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control) override {
    return dense_->solve(b, columns, x, control);
  }

  int analyses = 0, factorisations = 0;

 private:
  std::unique_ptr<LinearSolver> dense_ = make_linear_solver(LinearSolverKind::kDense);
};

TEST(AnOwnLinearSolver, SolvesAllSystemsOfOptimizeAndIsNamedInTheReport) {
  Graph own, library;
  add_noisy_circle(own, 20);
  add_noisy_circle(library, 20);
  const auto solver = std::make_shared<CountingSolver>();
  Options options;
  options.own_linear_solver = solver;
  const Report report = optimize(own, options);
  EXPECT_TRUE(report.converged()) << report;
  EXPECT_EQ(report.linear_solver, "counting");
  EXPECT_GE(solver->factorisations, report.iterations);
  const double chi2 = optimize(library).chi2_final;
  EXPECT_NEAR(report.chi2_final, chi2, 1e-9 * chi2);
}

TEST(AnOwnLinearSolver, ServesSeveralGraphsInTurn) {
  Graph small, large;
  const auto first = add_noisy_circle(small, 10);
  add_noisy_circle(large, 30);
  const auto solver = std::make_shared<CountingSolver>();
  Options options;
  options.own_linear_solver = solver;
  const double chi2 = optimize(small, options).chi2_final;
  EXPECT_TRUE(optimize(large, options).converged());
  small.set_estimate(first[3], SE2(1, 2, 0.1));
  const Report again = optimize(small, options);
  EXPECT_TRUE(again.converged()) << again;
  EXPECT_NEAR(again.chi2_final, chi2, 1e-8 * chi2);
  EXPECT_EQ(solver->analyses, 3);
  EXPECT_NE(optimize(small).linear_solver, "counting") << "only where it is asked for";
}

}  // namespace
}  // namespace boxplus
