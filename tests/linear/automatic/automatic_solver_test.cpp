// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <atomic>

#include "boxplus/linear/make_linear_solver.h"
#include "linear/expect_solution.h"

namespace boxplus {
namespace {

using Eigen::MatrixXd;

std::unique_ptr<LinearSolver> automatic_solver(const AutomaticSolverOptions& options,
                                               const BlockCholeskyOptions& block_cholesky = {}) {
  return make_linear_solver(LinearSolverKind::kAutomatic,
                            {.block_cholesky = block_cholesky, .automatic = options});
}

TEST(AutomaticSolver, ChoosesTheBlockCholeskyForASmallSystem) {
  TestSystem system = random_system(20, 20, 1);
  const auto solver = make_linear_solver(LinearSolverKind::kAutomatic);
  EXPECT_EQ(solver->name(), "block_cholesky");
  solver->analyze(system.structure, {});
  EXPECT_EQ(solver->name(), "block_cholesky");
  EXPECT_EQ(solver->statistics().refused_factor_bytes, 0u);
}

TEST(AutomaticSolver, ChoosesPcgIfTheFactorDoesNotFitIntoMemory) {
  TestSystem system = random_system(20, 20, 1);
  const auto analyzed = [&](std::uint64_t max_factor_bytes) {
    auto solver = automatic_solver({.max_factor_bytes = max_factor_bytes});
    solver->analyze(system.structure, {});
    return solver;
  };
  const auto solver = analyzed(100);
  EXPECT_EQ(solver->name(), "pcg");
  const std::uint64_t bytes = solver->statistics().refused_factor_bytes;
  EXPECT_GE(bytes, 8 * system.structure.nonzero_values() / 2);
  EXPECT_EQ(analyzed(bytes)->name(), "block_cholesky");
  EXPECT_EQ(analyzed(bytes - 1)->name(), "pcg");
}

TEST(AutomaticSolver, ChoosesPcgIfTheFactorizationIsPredictedToTakeMuchLonger) {
  const BlockStructure structure = cube(30, 6);
  const auto solver =
      automatic_solver({.max_factor_bytes = std::uint64_t{1} << 60}, {.ordering = Ordering::kMinimumDegree});
  solver->analyze(structure, {});
  EXPECT_EQ(solver->name(), "pcg");
  const LinearStatistics statistics = solver->statistics();
  EXPECT_GT(statistics.factor_seconds, 4 * statistics.pcg_seconds);
  EXPECT_GT(statistics.refused_factor_bytes, 0u);
  solver->analyze(cube(10, 6), {});
  EXPECT_EQ(solver->name(), "block_cholesky");
  EXPECT_GT(solver->statistics().factor_seconds, 0);
}

TEST(AutomaticSolver, SolvesAndStopsLikeTheSolverThatItChose) {
  TestSystem system = random_system(20, 20, 1);
  const AssembledSystem view = system.view();
  for (const std::uint64_t limit : {std::uint64_t{0}, std::uint64_t{1}}) {
    const auto solver = automatic_solver({.max_factor_bytes = limit});
    solver->analyze(system.structure, {});
    ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
    const MatrixXd b = right_hand_sides(system, 1);
    MatrixXd x = b;
    ASSERT_EQ(solver->solve(x.data(), 1, x.data(), {.relative_tolerance = 1e-12}).status, LinearStatus::kOk);
    expect_solution(system.dense(), x, b);
    const std::atomic<bool> flag{true};
    EXPECT_EQ(solver->factorize(view, {}, {.stop = StopToken(&flag)}).status, LinearStatus::kStopped);
  }
}

TEST(AutomaticSolver, StopsPcgAtTheMinimumToleranceOfItsOptions) {
  TestSystem system = random_system(200, 300, 1);
  const AssembledSystem view = system.view();
  int iterations[2];
  for (const double least : {0.0, 0.1}) {
    const auto solver = automatic_solver({.max_factor_bytes = 1, .min_tolerance = least});
    solver->analyze(system.structure, {});
    ASSERT_EQ(solver->factorize(view, {}).status, LinearStatus::kOk);
    MatrixXd b = right_hand_sides(system, 1), x = b;
    iterations[least > 0] = solver->solve(b.data(), 1, x.data(), {.relative_tolerance = 1e-12}).iterations;
    const double residual = (system.dense() * x - b).norm() / b.norm();
    EXPECT_LE(residual, std::max(least, 1e-11));
    EXPECT_GE(residual, least / 100);
  }
  EXPECT_LT(iterations[1], iterations[0]);
}

}  // namespace
}  // namespace boxplus
