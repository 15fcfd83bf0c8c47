// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/path_inverse.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <random>

#include "linear/block_cholesky/numeric_factor.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

/// The factor of a system.
struct Factor {
  SymbolicFactor symbolic;
  NumericFactor<double> numeric;

  explicit Factor(const TestSystem& system) : symbolic(analyze_structure(system.structure, {})) {
    numeric.allocate(symbolic, system.structure.scalars(), 1);
    const FrontsResult result =
        factorize_fronts(symbolic, system.structure, system.values.data(), {}, {}, numeric);
    EXPECT_EQ(result.status, LinearStatus::kOk);
  }
};

/// Blocks in the lower triangle for every pair of some random blocks.
std::vector<BlockCoordinate> random_pairs(std::uint32_t blocks, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint32_t> some(1 + seed % 5);
  for (std::uint32_t& block : some) block = random() % blocks;
  std::vector<BlockCoordinate> pairs;
  for (const std::uint32_t row : some) {
    for (const std::uint32_t column : some) {
      if (row >= column) pairs.push_back({row, column});
    }
  }
  return pairs;
}

TEST(PathInverse, EqualsTheDenseInverseOn200RandomStructures) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    TestSystem system = random_system(1 + seed % 60, seed % 50, seed);
    const BlockStructure& structure = system.structure;
    const Factor factor(system);
    const Eigen::MatrixXd dense = system.dense().inverse();
    const auto pairs = random_pairs(structure.blocks(), seed);
    std::size_t size = 0;
    for (const auto& [row, column] : pairs) size += std::size_t{structure.dim(row)} * structure.dim(column);
    std::vector<double> out(size, std::numeric_limits<double>::quiet_NaN());
    const auto requests = list_requests(structure, pairs, out.data());
    PathInverse inverse(factor.symbolic, requests);
    ASSERT_TRUE(inverse.compute(factor.numeric.arena(), {}));
    for (const InverseRequest& request : requests) {
      const auto [row, column] = request.block;
      const Eigen::Map<const Eigen::MatrixXd> actual(request.out, structure.dim(row), structure.dim(column));
      const Eigen::MatrixXd expected = dense.block(structure.offset[row], structure.offset[column],
                                                   structure.dim(row), structure.dim(column));
      EXPECT_LE((actual - expected).cwiseAbs().maxCoeff(), 1e-9 * dense.cwiseAbs().maxCoeff());
    }
  }
}

TEST(PathInverse, ReadsOnlyThePathToTheRoot) {
  const TestSystem system = random_system(60, 0, 1);
  const Factor factor(system);
  const std::uint32_t last = factor.symbolic.order.back(), first = factor.symbolic.order.front();
  double out[36];
  const auto flops_of = [&](std::uint32_t block) {
    const BlockCoordinate pair{block, block};
    return PathInverse(factor.symbolic, list_requests(system.structure, {&pair, 1}, out)).flops();
  };
  EXPECT_LT(flops_of(last), flops_of(first));
}

TEST(PathInverse, CanBeStopped) {
  const TestSystem system = random_system(600, 500, 3);
  const Factor factor(system);
  std::vector<BlockCoordinate> pairs;
  for (std::uint32_t k = 0; k < 600; ++k) pairs.push_back({k, k});
  std::vector<double> out(600 * 36);
  const auto requests = list_requests(system.structure, pairs, out.data());
  PathInverse inverse(factor.symbolic, requests);
  const std::atomic<bool> stop = true;
  EXPECT_FALSE(inverse.compute(factor.numeric.arena(), StopToken(&stop)));
}

}  // namespace
}  // namespace boxplus
