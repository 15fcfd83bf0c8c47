// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/block_structure.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using ::testing::ElementsAre;

TEST(BlockStructure, SortsCoordinatesAndDropsDuplicates) {
  const auto s = make_block_structure({2, 1, 3}, {{2, 0}, {1, 0}, {2, 0}});
  EXPECT_THAT(s.offset, ElementsAre(0, 2, 3, 6));
  EXPECT_THAT(s.column_start, ElementsAre(0, 3, 4, 5));
  EXPECT_THAT(s.row, ElementsAre(0, 1, 2, 1, 2));
  EXPECT_THAT(s.value_start, ElementsAre(0, 4, 6, 12, 13, 22));
}

TEST(BlockStructure, FindsOnlyBlocksThatExist) {
  const auto s = make_block_structure({2, 1, 3}, {{2, 0}});
  EXPECT_EQ(s.find(0, 0), 0u);
  EXPECT_EQ(s.find(2, 0), 1u);
  EXPECT_EQ(s.find(1, 0), BlockStructure::kAbsent);
  EXPECT_EQ(s.find(0, 2), BlockStructure::kAbsent);
  EXPECT_EQ(s.find(3, 0), BlockStructure::kAbsent);
}

TEST(BlockStructure, MayBeEmpty) {
  const auto s = make_block_structure({}, {});
  EXPECT_EQ(s, BlockStructure{});
  EXPECT_EQ(s.blocks(), 0u);
  EXPECT_EQ(s.nonzero_values(), 0u);
}

TEST(BlockStructure, RefusesCoordinatesOutsideTheLowerTriangle) {
  EXPECT_THROW(make_block_structure({1, 1}, {{0, 1}}), InvalidArgument);
  EXPECT_THROW(make_block_structure({1, 1}, {{1, 1}}), InvalidArgument);
  EXPECT_THROW(make_block_structure({1, 1}, {{2, 1}}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
