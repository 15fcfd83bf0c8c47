// SPDX-License-Identifier: BSD-3-Clause
#include "linear/pcg/pcg.h"

#include <gtest/gtest.h>

#include "linear/test_system.h"

namespace boxplus {
namespace {

/// A system without block values: it only offers products with vectors and its diagonal blocks.
class OperatorOnly final : public BlockSystem {
 public:
  explicit OperatorOnly(const AssembledSystem& system) : system_(system) {}
  const BlockStructure& structure() const override { return system_.structure(); }
  std::span<const double> values() const override { return {}; }
  void multiply(const double* x, double* y) const override { system_.multiply(x, y); }
  void block_diagonal(double* out) const override { system_.block_diagonal(out); }

 private:
  AssembledSystem system_;
};

class PcgTest : public ::testing::Test {
 protected:
  PcgTest() : system(random_system(30, 30, 1)), b(system.structure.scalars(), 1.0), x(b.size(), 0.0) {
    solver.analyze(system.structure, {});
  }
  TestSystem system;
  std::vector<double> b, x;
  Pcg solver;
};

TEST_F(PcgTest, NeedsNoBlockValues) {
  const OperatorOnly operator_only(system.view());
  EXPECT_EQ(solver.needs(), LinearSolver::Needs::kOperator);
  ASSERT_EQ(solver.factorize(operator_only, {}, {}).status, LinearStatus::kOk);
  EXPECT_EQ(solver.solve(b.data(), 1, x.data(), {}).status, LinearStatus::kOk);
}

TEST_F(PcgTest, SolvesABlockDiagonalSystemInOneIteration) {
  TestSystem diagonal({2, 3}, {});
  diagonal.block(0, 0) << 2, 1, 1, 5;
  diagonal.block(1, 1) << 4, 1, 0, 1, 3, 1, 0, 1, 9;
  solver.analyze(diagonal.structure, {});
  const AssembledSystem view = diagonal.view();
  ASSERT_EQ(solver.factorize(view, {}, {}).status, LinearStatus::kOk);
  EXPECT_EQ(solver.solve(b.data(), 1, x.data(), {}).iterations, 1);
}

TEST_F(PcgTest, StopsEarlierAtALooserTolerance) {
  const AssembledSystem view = system.view();
  ASSERT_EQ(solver.factorize(view, {}, {}).status, LinearStatus::kOk);
  const int loose = solver.solve(b.data(), 1, x.data(), {.relative_tolerance = 1e-2}).iterations;
  EXPECT_LT(loose, solver.solve(b.data(), 1, x.data(), {.relative_tolerance = 1e-10}).iterations);
}

TEST_F(PcgTest, ReportsThatTheIterationLimitWasReached) {
  const AssembledSystem view = system.view();
  ASSERT_EQ(solver.factorize(view, {}, {}).status, LinearStatus::kOk);
  const SolveResult result = solver.solve(b.data(), 1, x.data(), {.max_iterations = 2});
  EXPECT_EQ(result.status, LinearStatus::kNotConverged);
  EXPECT_EQ(result.iterations, 2);
}

TEST_F(PcgTest, ObeysTheStopToken) {
  const AssembledSystem view = system.view();
  ASSERT_EQ(solver.factorize(view, {}, {}).status, LinearStatus::kOk);
  const std::atomic<bool> stop{true};
  EXPECT_EQ(solver.solve(b.data(), 1, x.data(), {.stop = StopToken(&stop)}).status, LinearStatus::kStopped);
}

TEST_F(PcgTest, DetectsAnIndefiniteMatrixEvenIfItsDiagonalBlocksArePositive) {
  TestSystem indefinite({1, 1}, {{1, 0}});
  indefinite.block(0, 0) << 1;
  indefinite.block(1, 0) << -2;
  indefinite.block(1, 1) << 1;
  solver.analyze(indefinite.structure, {});
  const AssembledSystem view = indefinite.view();
  ASSERT_EQ(solver.factorize(view, {}, {}).status, LinearStatus::kOk);
  EXPECT_EQ(solver.solve(b.data(), 1, x.data(), {}).status, LinearStatus::kNotPositiveDefinite);
}

}  // namespace
}  // namespace boxplus
