// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/symbolic_factor.h"

#include <gmock/gmock.h>

#include "linear/test_system.h"

namespace boxplus {
namespace {

const AmalgamationRule kNoMerging{.max_zero_fraction = -1};

std::vector<BlockCoordinate> complete_edges(std::uint32_t first, std::uint32_t end) {
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t j = first; j < end; ++j) {
    for (std::uint32_t i = j + 1; i < end; ++i) edges.push_back({i, j});
  }
  return edges;
}

TEST(SymbolicFactor, OfACompleteGraphIsOneFront) {
  const auto s = make_block_structure({3, 6, 1, 2, 3}, complete_edges(0, 5));
  const SymbolicFactor f = analyze_structure(s, {}, kNoMerging);
  ASSERT_EQ(f.fronts.size(), 1u);
  EXPECT_EQ(f.fronts[0].columns, 15u);
  EXPECT_EQ(f.fronts[0].below, 0u);
}

TEST(SymbolicFactor, OfTwoCliquesThatShareABlockHasOneSupernodePerClique) {
  auto edges = complete_edges(0, 4);  // blocks 0–3 and 3–6: block 3 is shared
  for (const auto& edge : complete_edges(3, 7)) edges.push_back(edge);
  const auto s = make_block_structure(std::vector<std::uint32_t>(7, 2), edges);
  const SymbolicFactor f = analyze_structure(s, {}, {.max_zero_fraction = 0});
  ASSERT_EQ(f.fronts.size(), 2u);
  EXPECT_EQ(f.fronts[0].columns, 6u);  // the three blocks that belong to one clique only
  EXPECT_EQ(f.fronts[0].below, 2u);
  EXPECT_EQ(f.fronts[1].columns, 8u);
  EXPECT_EQ(f.fronts[0].parent, 1u);
}

TEST(SymbolicFactor, CountsTheOperationsOfADenseMatrix) {
  const auto s = make_block_structure({2, 2}, {{1, 0}});
  EXPECT_EQ(analyze_structure(s, {}).flops, 16 + 9 + 4 + 1);
}

TEST(SymbolicFactor, MergesSmallFrontsOfAChainUpToTheMaximumFractionOfZeros) {
  const auto s = make_block_structure(std::vector<std::uint32_t>(200, 3), chain_edges(200));
  const SymbolicFactor separate = analyze_structure(s, {}, kNoMerging), merged = analyze_structure(s, {});
  EXPECT_LT(merged.fronts.size(), separate.fronts.size());
  const auto entries = [](const SymbolicFactor& f) {
    double sum = 0;
    for (const Front& front : f.fronts) sum += front.columns * ((front.columns + 1) / 2.0 + front.below);
    return sum;
  };
  EXPECT_LE(entries(merged) * (1 - AmalgamationRule{}.max_zero_fraction), entries(separate));
}

TEST(SymbolicFactor, PutsTheLastBlocksAtTheEndInTheGivenOrder) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const BlockStructure s = random_system(40, 30, seed).structure;
    const std::vector<std::uint32_t> last{5, 39, 0, 17};
    const SymbolicFactor f = analyze_structure(s, last);
    EXPECT_THAT(std::vector(f.order.end() - 4, f.order.end()), ::testing::ElementsAreArray(last));
  }
}

TEST(SymbolicFactor, MapsTheRowsOfEveryFrontIntoItsParent) {
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const BlockStructure s = random_system(60, 50, seed).structure;
    const SymbolicFactor f = analyze_structure(s, {});
    for (const Front& front : f.fronts) {
      if (front.below == 0) continue;
      ASSERT_NE(front.parent, kNoParent);
      std::uint32_t covered = 0;
      for (const ScalarRun& run : f.all_runs(front)) {
        EXPECT_EQ(run.source, covered);
        covered += run.length;
        EXPECT_LE(run.destination + run.length, f.fronts[front.parent].rows());
      }
      EXPECT_EQ(covered, front.below);
      for (const ScalarRun& run : f.pivot_runs(front)) {
        EXPECT_LE(run.destination + run.length, f.fronts[front.parent].columns);
      }
      for (const std::uint32_t row : f.rows(front))
        EXPECT_NE(f.row_in(f.fronts[front.parent], row), kNoParent);
    }
  }
}

/// The prediction is for one thread. The factor is a bit larger, because leading dimensions are rounded up.
TEST(FactorOutline, PredictsTheSizeOfTheFactor) {
  for (const std::uint32_t side : {3u, 10u, 25u}) {
    const BlockStructure structure =
        make_block_structure(std::vector<std::uint32_t>(side * side, 3), grid_edges(side, side));
    const FactorOutline outline = outline_factor(structure, {});
    const SymbolicFactor factor = complete_factor(structure, outline);
    const auto numbers = static_cast<double>(factor.panel_size + factor.update_size);
    EXPECT_GE(numbers, outline.partition.numbers);
    EXPECT_LE(numbers, 1.15 * outline.partition.numbers);
  }
}

}  // namespace
}  // namespace boxplus
