// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/elimination_tree.h"

#include <gmock/gmock.h>

#include <numeric>

#include "linear/test_system.h"

namespace boxplus {
namespace {

using ::testing::ElementsAre;

std::vector<std::uint32_t> natural(std::uint32_t blocks) {
  std::vector<std::uint32_t> order(blocks);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

/// The nonzero rows of each column of L. This simple algorithm eliminates one column after the other.
std::vector<std::vector<bool>> filled_pattern(const BlockStructure& s) {
  const std::uint32_t n = s.blocks();
  std::vector<std::vector<bool>> l(n, std::vector<bool>(n, false));
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t k = s.column_start[j]; k < s.column_start[j + 1]; ++k) l[j][s.row[k]] = true;
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t a = j + 1; a < n; ++a) {
      for (std::uint32_t b = a; b < n; ++b) {
        if (l[j][a] && l[j][b]) l[a][b] = true;
      }
    }
  }
  return l;
}

TEST(EliminationTree, OfAChainIsAPath) {
  const auto s = make_block_structure({1, 1, 1, 1}, chain_edges(4));
  EXPECT_THAT(elimination_tree(UpperPattern(s, natural(4))), ElementsAre(1, 2, 3, kNoParent));
}

TEST(EliminationTree, OfUnconnectedBlocksHasOnlyRoots) {
  const auto s = make_block_structure({1, 1}, {});
  EXPECT_THAT(elimination_tree(UpperPattern(s, natural(2))), ElementsAre(kNoParent, kNoParent));
}

TEST(EliminationTree, AgreesWithASimpleEliminationOnRandomPatterns) {
  for (std::uint32_t seed = 0; seed < 50; ++seed) {
    const BlockStructure s = random_system(2 + seed, seed, seed).structure;
    const auto l = filled_pattern(s);
    const UpperPattern pattern(s, natural(s.blocks()));
    const auto parent = elimination_tree(pattern);
    std::vector<std::uint32_t> dims;
    for (std::uint32_t j = 0; j < s.blocks(); ++j) dims.push_back(s.dim(j));
    const auto counts = count_columns(pattern, parent, dims);
    for (std::uint32_t j = 0; j < s.blocks(); ++j) {
      std::uint32_t first = kNoParent, blocks = 0, scalars = 0;
      for (std::uint32_t i = s.blocks(); i-- > j + 1;) {
        if (l[j][i]) first = i, ++blocks, scalars += dims[i];
      }
      EXPECT_EQ(parent[j], first);
      EXPECT_EQ(counts.blocks[j], blocks);
      EXPECT_EQ(counts.scalars[j], scalars);
    }
  }
}

TEST(Postorder, VisitsChildrenJustBeforeTheirParent) {
  const std::vector<std::uint32_t> parent{3, 4, 3, 5, 5, kNoParent};
  EXPECT_THAT(postorder(parent, 0), ElementsAre(0, 2, 3, 1, 4, 5));
}

TEST(Postorder, LeavesTheRequestedNumberOfNodesAtTheEnd) {
  const std::vector<std::uint32_t> parent{2, 3, 5, 4, kNoParent, kNoParent};
  EXPECT_THAT(postorder(parent, 2), ElementsAre(0, 2, 1, 3, 4, 5));
}

}  // namespace
}  // namespace boxplus
