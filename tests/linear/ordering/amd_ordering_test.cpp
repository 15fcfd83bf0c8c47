// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/amd_ordering.h"

#include <gmock/gmock.h>

#include <numeric>

#include "boxplus/base/error.h"
#include "linear/test_system.h"

namespace boxplus {
namespace {

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> v) {
  std::sort(v.begin(), v.end());
  return v;
}

TEST(AmdOrdering, ContainsEveryBlockOnce) {
  const TestSystem system = random_system(200, 300, 5);
  std::vector<std::uint32_t> all(200);
  std::iota(all.begin(), all.end(), 0u);
  EXPECT_EQ(sorted(amd_ordering(system.structure)), all);
}

TEST(AmdOrdering, EliminatesTheLeavesOfAStarBeforeItsCenter) {
  std::vector<BlockCoordinate> edges;
  for (std::uint32_t leaf = 1; leaf < 30; ++leaf) edges.push_back({leaf, 0});
  const auto order = amd_ordering(make_block_structure(std::vector<std::uint32_t>(30, 3), edges));
  // The center may come before the last leaf.
  EXPECT_GE(std::find(order.begin(), order.end(), 0u) - order.begin(), 28);
}

TEST(AmdOrdering, PutsTheBlocksThatMustBeLastAtTheEndInTheGivenOrder) {
  const TestSystem system = random_system(50, 60, 5);
  const std::vector<std::uint32_t> last{7, 3, 20};
  const auto order = amd_ordering(system.structure, last);
  EXPECT_THAT(std::vector(order.end() - 3, order.end()), ::testing::ElementsAre(7, 3, 20));
  EXPECT_EQ(sorted(order).back(), 49u);
}

TEST(AmdOrdering, AcceptsStructuresWithoutBlocksAndWithLastBlocksOnly) {
  const std::vector<std::uint32_t> last{1, 0};
  EXPECT_EQ(amd_ordering(make_block_structure({1, 1}, {{1, 0}}), last), last);
  EXPECT_TRUE(amd_ordering(BlockStructure{}).empty());
}

TEST(AmdOrdering, RefusesUnknownOrRepeatedLastBlocks) {
  const auto structure = make_block_structure({1, 1}, {});
  EXPECT_THROW(amd_ordering(structure, std::vector<std::uint32_t>{2}), InvalidArgument);
  EXPECT_THROW(amd_ordering(structure, std::vector<std::uint32_t>{1, 1}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
