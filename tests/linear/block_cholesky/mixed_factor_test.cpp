// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/mixed_factor.h"

#include <gtest/gtest.h>

#include <cmath>

#include "linear/block_cholesky/block_cholesky.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

using Eigen::VectorXd;

/// A grid with a prior on one block only. The smaller `prior` is, the larger is the condition number.
TestSystem loose_grid(double prior) {
  const auto edges = grid_edges(12, 12);
  TestSystem system(std::vector<std::uint32_t>(144, 3), edges);
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  for (const auto& [i, j] : edges) system.add_edge(i, j, identity, -identity);
  system.block(0, 0) += prior * identity;
  return system;
}

struct Solution {
  LinearStatistics statistics;
  SolveResult result;
  double residual = 0;  ///< |A x − b| / |b|
};

Solution solve(TestSystem& system, Precision precision, const SolveControl& control = {}) {
  BlockCholesky solver({.precision = precision});
  solver.analyze(system.structure, {});
  EXPECT_EQ(solver.factorize(system.view(), {}, {}).status, LinearStatus::kOk);
  const VectorXd b = VectorXd::LinSpaced(system.structure.scalars(), -1, 2);
  VectorXd x(b.size());
  Solution solution;
  solution.result = solver.solve(b.data(), 1, x.data(), control);
  solution.statistics = solver.statistics();
  solution.residual = (system.dense() * x - b).norm() / b.norm();
  return solution;
}

TEST(MixedFactor, RefinesItsSolutionToTheTolerance) {
  TestSystem system = loose_grid(1);
  for (const double tolerance : {1e-3, 1e-6, 1e-10, 1e-13}) {
    const Solution solution = solve(system, Precision::kMixed, {.relative_tolerance = tolerance});
    EXPECT_EQ(solution.result.status, LinearStatus::kOk);
    EXPECT_LE(solution.residual, 1.01 * tolerance);
    EXPECT_EQ(solution.statistics.precision, Precision::kMixed);
    EXPECT_FALSE(solution.statistics.fell_back_to_double);
    EXPECT_GT(solution.result.iterations, 0);
  }
}

TEST(MixedFactor, TakesFewStepsIfFloatHasEnoughDigits) {
  TestSystem system = loose_grid(1);
  EXPECT_LE(solve(system, Precision::kMixed, {.relative_tolerance = 1e-6}).result.iterations, kUsualSteps);
}

TEST(MixedFactor, FallsBackToDoubleIfFloatHasTooFewDigits) {
  TestSystem system = loose_grid(1e-7);
  const Solution solution = solve(system, Precision::kMixed);
  EXPECT_EQ(solution.result.status, LinearStatus::kOk);
  EXPECT_LT(solution.residual, 1e-6);  // as accurate as a double-precision factor
  EXPECT_EQ(solution.statistics.precision, Precision::kDouble);
  EXPECT_TRUE(solution.statistics.fell_back_to_double);
}

TEST(MixedFactor, FallsBackToDoubleIfValuesAreTooLargeForFloat) {
  TestSystem system = loose_grid(1);
  for (double& value : system.values) value *= 1e60;
  const Solution solution = solve(system, Precision::kMixed);
  EXPECT_EQ(solution.result.status, LinearStatus::kOk);
  EXPECT_LT(solution.residual, 1e-10);
  EXPECT_TRUE(solution.statistics.fell_back_to_double);
}

TEST(MixedFactor, FallsBackToDoubleIfASolveMissesItsTolerance) {
  TestSystem system = loose_grid(1);
  const Solution solution = solve(system, Precision::kMixed, {.relative_tolerance = 1e-17});
  EXPECT_EQ(solution.result.status, LinearStatus::kOk);
  EXPECT_LT(solution.residual, 1e-12);
  EXPECT_TRUE(solution.statistics.fell_back_to_double);
}

TEST(MixedFactor, FallsBackToDoubleToFindTheFailedBlockOfASingularMatrix) {
  // The edge between blocks 200 and 201 measures only a translation, so the blocks from 201 on may rotate.
  TestSystem system(std::vector<std::uint32_t>(400, 3), chain_edges(400));
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d lever = identity;
  lever(1, 2) = 1;  // the second coordinate of a block depends on the angle of the previous block
  for (std::uint32_t k = 0; k + 1 < 400; ++k) {
    if (k == 200) {
      system.add_edge(k, k + 1, identity.topRows(2), -identity.topRows(2));
    } else {
      system.add_edge(k, k + 1, lever, -identity);
    }
  }
  system.block(0, 0) += identity;
  std::vector<FactorResult> results;
  for (const Precision precision : {Precision::kDouble, Precision::kMixed}) {
    BlockCholesky solver({.precision = precision});
    solver.analyze(system.structure, {});
    results.push_back(solver.factorize(system.view(), {}, {}));
    EXPECT_EQ(solver.statistics().fell_back_to_double, precision == Precision::kMixed);
  }
  EXPECT_EQ(results[0].status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(results[1].status, LinearStatus::kNotPositiveDefinite);
  EXPECT_EQ(results[1].failed_block, results[0].failed_block);
}

TEST(MixedFactor, IsTriedAgainAfterANewAnalysis) {
  TestSystem bad = loose_grid(1e-7), good = loose_grid(1);
  BlockCholesky solver({.precision = Precision::kMixed});
  solver.analyze(bad.structure, {});
  ASSERT_EQ(solver.factorize(bad.view(), {}, {}).status, LinearStatus::kOk);
  EXPECT_TRUE(solver.statistics().fell_back_to_double);
  solver.analyze(good.structure, {});
  ASSERT_EQ(solver.factorize(good.view(), {}, {}).status, LinearStatus::kOk);
  EXPECT_EQ(solver.statistics().precision, Precision::kMixed);
}

TEST(MixedFactor, IsTheAutomaticChoiceForLargeFrontsOnly) {
  const auto chosen = [](const BlockStructure& structure) {
    BlockCholesky solver;
    solver.analyze(structure, {});
    return solver.statistics().precision;
  };
  EXPECT_EQ(chosen(make_block_structure(std::vector<std::uint32_t>(2000, 3), chain_edges(2000))),
            Precision::kDouble);
  EXPECT_EQ(chosen(cube(12, 6)), Precision::kMixed);
}

TEST(MixedFactor, MayTakeMoreRefinementStepsIfTheFactorizationCostsMore) {
  const BlockStructure structure = cube(6, 6);
  const double few = steps_that_pay(2e-3, 1e7, 1e5, structure);
  EXPECT_GT(few, 0);
  EXPECT_GT(steps_that_pay(2e-2, 1e8, 1e5, structure), few);
  EXPECT_EQ(steps_that_pay(1e-5, 1e5, 1e3, structure), 0)
      << "a short factorization leaves no time for refinement";
}

TEST(MixedFactor, ComputesTheSameBitsEveryTimeOnAnyNumberOfThreads) {
  std::mt19937 random(9);
  const TestSystem system = random_system(std::vector<std::uint32_t>(900, 6), grid_edges(30, 30), random);
  const VectorXd b = VectorXd::Ones(system.structure.scalars());
  std::vector<VectorXd> solutions;
  for (const int threads : {1, 1, 2, 3}) {
    BlockCholesky solver({.precision = Precision::kMixed});
    solver.analyze(system.structure, {.threads = threads});
    EXPECT_EQ(solver.symbolic().schedule.is_parallel(), threads > 1);
    ASSERT_EQ(solver.factorize(system.view(), {}, {}).status, LinearStatus::kOk);
    solutions.emplace_back(b.size());
    ASSERT_EQ(solver.solve(b.data(), 1, solutions.back().data(), {}).status, LinearStatus::kOk);
    EXPECT_EQ(solver.statistics().precision, Precision::kMixed);
  }
  for (const VectorXd& x : solutions) EXPECT_EQ(x, solutions.front());
}

}  // namespace
}  // namespace boxplus
