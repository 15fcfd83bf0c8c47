// SPDX-License-Identifier: BSD-3-Clause
#include "io/bal/number_block.h"

#include <gmock/gmock.h>

namespace boxplus {
namespace {

using testing::ElementsAre;

TEST(NumberBlock, HoldsTheNumbersAndFindsTheirPlaces) {
  const TextSource text("1 2.5\r\n\n\t-3 +4e1\n", "t");
  NumberBlock block;
  block.read(text, 0);
  EXPECT_THAT(block.values(), ElementsAre(1, 2.5, -3, 40));
  EXPECT_EQ(block.line_count(), 3);
  EXPECT_FALSE(block.ends_with_another_field());
  EXPECT_TRUE(block.is_integer(0) && block.is_integer(2));
  EXPECT_FALSE(block.is_integer(1) || block.is_integer(3));
  const NumberBlock::Field field = block.field(3);
  EXPECT_EQ(field.line, 2);
  EXPECT_EQ(field.column, 5);
  EXPECT_EQ(field.text, "+4e1");
}

TEST(NumberBlock, EndsAtTheFirstFieldThatIsNotANumber) {
  const TextSource text("1 2\n3 +-4 5\n", "t");
  NumberBlock block;
  block.read(text, 0);
  EXPECT_THAT(block.values(), ElementsAre(1, 2, 3));
  EXPECT_TRUE(block.ends_with_another_field());
  EXPECT_EQ(block.field(3).text, "+-4");
}

TEST(NumberBlock, IsEmptyIfNoLineBeginsInIt) {
  const TextSource text("123456789\n1\n", "t", 4);
  NumberBlock block;
  for (const std::size_t k : {1, 2}) {
    block.read(text, k);
    EXPECT_EQ(block.values().size(), k == 2 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace boxplus
