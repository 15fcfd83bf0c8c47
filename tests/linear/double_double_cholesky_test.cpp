// SPDX-License-Identifier: BSD-3-Clause
#include "linear/double_double_cholesky.h"

#include <gtest/gtest.h>

#include <atomic>
#include <random>
#include <vector>

#include "linear/test_system.h"

namespace boxplus {
namespace {

std::vector<DoubleDouble> widened(std::span<const double> values) {
  return {values.begin(), values.end()};
}

/// A random block system. Its entries are small integers, so that sums of their products are exact.
TestSystem integer_system(unsigned seed) {
  std::mt19937 random(seed);
  const std::uint32_t blocks = 2 + random() % 12;
  const std::vector<BlockCoordinate> edges = random_edges(blocks, 6, random);
  TestSystem system(random_dims(blocks, random), edges);
  const auto integers = [&](std::uint32_t block) {
    Eigen::MatrixXd matrix(4, system.structure.dim(block));
    for (double& value : matrix.reshaped()) value = static_cast<double>(random() % 7) - 3;
    return matrix;
  };
  for (const BlockCoordinate& edge : edges)
    system.add_edge(edge.row, edge.column, integers(edge.row), integers(edge.column));
  system.add_to_diagonal(1);
  return system;
}

TEST(DoubleDoubleCholesky, SolvesRandomBlockSystems) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    TestSystem system = integer_system(seed);
    const auto n = static_cast<Eigen::Index>(system.structure.scalars());
    const double lambda = seed % 2;
    Eigen::VectorXd damping = Eigen::VectorXd::Constant(n, 3);
    damping[0] = 5;
    const Eigen::VectorXd expected = Eigen::VectorXd::LinSpaced(n, -1, 2);
    const Eigen::VectorXd b = system.dense() * expected + lambda * damping.cwiseProduct(expected);
    DoubleDoubleCholesky cholesky;
    cholesky.analyze(system.structure, {}, {});
    for (int repetition = 0; repetition < 2; ++repetition) {
      ASSERT_EQ(cholesky.factorize(widened(system.values), {lambda, damping.data()}, {}).status,
                LinearStatus::kOk);
      std::vector<DoubleDouble> x = widened({b.data(), static_cast<std::size_t>(n)});
      cholesky.solve(x);
      for (Eigen::Index i = 0; i < n; ++i)
        EXPECT_NEAR(static_cast<double>(x[static_cast<std::size_t>(i)]), expected[i], 1e-10);
    }
  }
}

TEST(DoubleDoubleCholesky, KeepsRowsOfWeightOneBesideARowOfWeight1e18) {
  const BlockStructure structure = make_block_structure({1, 1}, {{1, 0}});
  // 1e18 (x + 3 y)² + (x − y)² has the minimum 0, and its gradient is linear. The right-hand side belongs to
  // x = 1, y = 2.
  const DoubleDouble w = 1e18;
  const std::vector<DoubleDouble> values{w + 1.0, w * 3.0 - 1.0, w * 9.0 + 1.0};
  std::vector<DoubleDouble> x{values[0] + values[1] * 2.0, values[1] + values[2] * 2.0};
  DoubleDoubleCholesky cholesky;
  cholesky.analyze(structure, {}, {});
  ASSERT_EQ(cholesky.factorize(values, {}, {}).status, LinearStatus::kOk);
  cholesky.solve(x);
  EXPECT_NEAR(static_cast<double>(x[0]), 1, 1e-12);
  EXPECT_NEAR(static_cast<double>(x[1]), 2, 1e-12);
}

TEST(DoubleDoubleCholesky, CountsItsMultiplications) {
  DoubleDoubleCholesky cholesky;
  cholesky.analyze(make_block_structure({2, 1, 1}, {{1, 0}, {2, 0}, {2, 1}}), {}, {});
  EXPECT_EQ(cholesky.multiplications(),
            6 + 3 + 1);  // the columns have 3, 2, 1 and 0 entries below the diagonal
  cholesky.analyze(make_block_structure({1, 1, 1}, {{2, 0}, {2, 1}}), {}, {});
  EXPECT_EQ(cholesky.multiplications(), 1 + 1);
}

TEST(DoubleDoubleCholesky, NamesThePivotThatIsLost) {
  for (const double shift : {0.0, -1.0, 1e-30}) {
    TestSystem system({1, 1, 1, 1}, chain_edges(4));
    const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);
    for (std::uint32_t i = 0; i + 1 < 4; ++i) system.add_edge(i + 1, i, one / 3, -one / 3);
    std::vector<DoubleDouble> values = widened(system.values);
    values[0] += shift;
    DoubleDoubleCholesky cholesky;
    const std::uint32_t last = 2;
    cholesky.analyze(system.structure, {&last, 1}, {});
    const FactorResult result = cholesky.factorize(values, {}, {});
    EXPECT_EQ(result.status, LinearStatus::kNotPositiveDefinite) << shift;
    if (shift >= 0) {
      EXPECT_EQ(result.failed_block, 2u);
    }
    EXPECT_EQ(result.failed_scalar, result.failed_block);
    EXPECT_EQ(cholesky.factorize(values, {1e-20, nullptr}, {}).status,
              shift < 0 ? LinearStatus::kNotPositiveDefinite : LinearStatus::kOk);
  }
}

TEST(DoubleDoubleCholesky, CanBeStopped) {
  const TestSystem system = integer_system(1);
  const std::atomic<bool> flag = true;
  DoubleDoubleCholesky cholesky;
  cholesky.analyze(system.structure, {}, {});
  EXPECT_EQ(cholesky.factorize(widened(system.values), {}, StopToken(&flag)).status, LinearStatus::kStopped);
}

}  // namespace
}  // namespace boxplus
