// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/extend_factor.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <string>

#include "linear/block_cholesky/block_cholesky.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

/// A structure that grows step by step. `growth` describes the last step.
struct Growing {
  std::vector<std::uint32_t> dims;
  std::vector<BlockCoordinate> pairs;
  BlockStructure structure;
  std::vector<BlockCoordinate> added;
  std::vector<std::uint32_t> new_index;
  StructureGrowth growth;

  void grow(const std::vector<std::uint32_t>& new_dims, const std::vector<BlockCoordinate>& new_pairs) {
    const BlockStructure old = structure;
    growth.old_blocks = old.blocks();
    dims.insert(dims.end(), new_dims.begin(), new_dims.end());
    added.clear();
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (const BlockCoordinate& pair : new_pairs) {
      const bool known =
          pair.row < old.blocks() && old.find(pair.row, pair.column) != BlockStructure::kAbsent;
      if (!known && seen.insert({pair.row, pair.column}).second) added.push_back(pair);
    }
    pairs.insert(pairs.end(), added.begin(), added.end());
    structure = make_block_structure(dims, pairs);
    new_index.clear();
    for (std::uint32_t j = 0; j < old.blocks(); ++j) {
      for (std::uint32_t k = old.column_start[j]; k < old.column_start[j + 1]; ++k)
        new_index.push_back(structure.find(old.row[k], j));
    }
    growth.added = added;
    growth.new_index = new_index;
  }
};

/// The values of a diagonally dominant matrix.
std::vector<double> values_of(const BlockStructure& s) {
  std::mt19937 random(3);
  std::uniform_real_distribution<> number(-1, 1);
  std::vector<double> values(s.nonzero_values());
  for (std::uint32_t j = 0; j < s.blocks(); ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) {
      const std::uint32_t rows = s.dim(s.row[k]);
      for (std::uint32_t v = s.value_start[k]; v < s.value_start[k + 1]; ++v) {
        const std::uint32_t row = (v - s.value_start[k]) % rows, column = (v - s.value_start[k]) / rows;
        values[v] = s.row[k] != j ? number(random) : row == column ? 200.0 : 0.1;
      }
    }
  }
  return values;
}

std::vector<double> solution(BlockCholesky& solver, const BlockStructure& structure) {
  const std::vector<double> values = values_of(structure);
  const AssembledSystem system(structure, values);
  EXPECT_EQ(solver.factorize(system, {0.5}, {}).status, LinearStatus::kOk);
  std::vector<double> x(structure.scalars());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i));
  EXPECT_EQ(solver.solve(x.data(), 1, x.data(), {}).status, LinearStatus::kOk);
  return x;
}

/// A random connected structure of `blocks` blocks.
Growing random_structure(std::mt19937& random, std::uint32_t blocks) {
  Growing result;
  std::vector<std::uint32_t> dims;
  std::vector<BlockCoordinate> pairs;
  for (std::uint32_t k = 0; k < blocks; ++k) {
    dims.push_back(1 + random() % 6);
    if (k > 0) pairs.push_back({k, k - 1});
    if (k > 5 && random() % 2 == 0) pairs.push_back({k, static_cast<std::uint32_t>(random() % (k - 1))});
  }
  result.grow(dims, pairs);
  return result;
}

class ExtendedFactorOfEitherPrecision : public ::testing::TestWithParam<Precision> {};

TEST_P(ExtendedFactorOfEitherPrecision, SolvesLikeANewFactor) {
  std::mt19937 random(1);
  int extended = 0;
  for (int round = 0; round < 20; ++round) {
    Growing growing = random_structure(random, 20 + 20 * static_cast<std::uint32_t>(round));
    BlockCholesky solver({.precision = GetParam()});
    solver.analyze(growing.structure, {});
    for (int step = 0; step < 12; ++step) {
      const std::uint32_t old = growing.structure.blocks(), count = random() % 4;
      std::vector<std::uint32_t> dims;
      std::vector<BlockCoordinate> pairs;
      for (std::uint32_t k = old; k < old + count; ++k) {
        dims.push_back(1 + random() % 6);
        for (std::uint32_t e = 0; e < 1 + random() % 3; ++e)
          pairs.push_back({k, e == 0 ? k - 1 : static_cast<std::uint32_t>(random() % (k - 1))});
      }
      if (random() % 3 == 0) pairs.push_back({old - 1, old - 3});
      growing.grow(dims, pairs);
      if (solver.extend(growing.growth)) {
        ++extended;
      } else {
        solver.analyze(growing.structure, {});
      }
      BlockCholesky fresh({.precision = Precision::kDouble});
      fresh.analyze(growing.structure, {});
      const auto expected = solution(fresh, growing.structure), found = solution(solver, growing.structure);
      for (std::size_t i = 0; i < found.size(); ++i) ASSERT_NEAR(found[i], expected[i], 1e-11);
    }
  }
  EXPECT_GT(extended, 100);
}

INSTANTIATE_TEST_SUITE_P(Precisions, ExtendedFactorOfEitherPrecision,
                         ::testing::Values(Precision::kDouble, Precision::kMixed),
                         [](const auto& test) { return std::string(to_string(test.param)); });

TEST(ExtendedFactor, HasTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<double>> solutions;
  for (const int threads : {1, 2, 3}) {
    Growing growing;
    growing.grow(std::vector<std::uint32_t>(1600, 6), grid_edges(40, 40));
    BlockCholesky solver({.precision = Precision::kDouble});
    solver.analyze(growing.structure, {.threads = threads});
    for (std::uint32_t k = 0; k < 5; ++k) {
      growing.grow({6}, {{1600 + k, 1599 + k}, {1600 + k, 40 * k}, {1600 + k, 777}});
      ASSERT_TRUE(solver.extend(growing.growth));
    }
    EXPECT_EQ(solver.symbolic().schedule.is_parallel(), threads > 1);
    solutions.push_back(solution(solver, growing.structure));
  }
  EXPECT_EQ(solutions[0], solutions[1]);
  EXPECT_EQ(solutions[0], solutions[2]);
}

TEST(ExtendedFactor, ComputesTheInverseOnItsPattern) {
  std::mt19937 random(5);
  Growing growing = random_structure(random, 60);
  BlockCholesky solver, fresh;
  solver.analyze(growing.structure, {});
  growing.grow({3, 2}, {{60, 59}, {60, 7}, {61, 60}, {61, 30}});
  ASSERT_TRUE(solver.extend(growing.growth));
  fresh.analyze(growing.structure, {});
  std::vector<BlockCoordinate> blocks;
  std::size_t numbers = 0;
  for (std::uint32_t k = 0; k < growing.structure.blocks(); ++k) {
    blocks.push_back({k, k});
    numbers += std::size_t{growing.dims[k]} * growing.dims[k];
  }
  std::vector<double> expected(numbers), found(numbers);
  solution(solver, growing.structure);
  solution(fresh, growing.structure);
  ASSERT_TRUE(solver.selected_inverse(blocks, found.data()));
  ASSERT_TRUE(fresh.selected_inverse(blocks, expected.data()));
  for (std::size_t i = 0; i < numbers; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12);
}

TEST(ExtendedFactor, IsRefusedIfANewEdgeConnectsOldBlocksOutsideOfThePattern) {
  Growing growing;  // two chains without a connection
  std::vector<BlockCoordinate> pairs;
  for (std::uint32_t k = 1; k < 40; ++k) {
    if (k != 20) pairs.push_back({k, k - 1});
  }
  growing.grow(std::vector<std::uint32_t>(40, 3), pairs);
  SymbolicFactor factor = analyze_structure(growing.structure, {});
  growing.grow({}, {{35, 3}});
  EXPECT_FALSE(extend_factor(growing.structure, growing.growth, factor));
}

TEST(ExtendedFactor, IsRefusedAfterAHundredExtensions) {
  Growing growing;
  growing.grow({3, 3}, {{1, 0}});
  BlockCholesky solver;
  solver.analyze(growing.structure, {});
  int extensions = 0;
  for (;; ++extensions) {
    const std::uint32_t last = growing.structure.blocks();
    growing.grow({3}, {{last, last - 1}});
    if (!solver.extend(growing.growth)) break;
  }
  EXPECT_EQ(extensions, 100);
}

}  // namespace
}  // namespace boxplus
