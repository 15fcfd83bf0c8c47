// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/line_block.h"

#include <gmock/gmock.h>

namespace boxplus {
namespace {

using testing::ElementsAre;

const Renames kNoRenames;

TEST(LineBlock, SplitsLinesIntoTagsAndValues) {
  LineBlock block;
  block.read(
      TextSource("# a comment\n\nVERTEX_SE2 7 1 0.5 -3 # odd\nVERTEX_SE2 8 x 0 0\nFIX 7\nODD 1\n", "g"), 0,
      {default_registry(), kNoRenames});
  ASSERT_EQ(block.lines().size(), 5u);
  EXPECT_EQ(block.line_count(), 6);
  EXPECT_EQ(block.lines()[0].kind, Line::Kind::kComment);
  const Line& vertex = block.lines()[1];
  EXPECT_EQ(vertex.kind, Line::Kind::kElement);
  EXPECT_EQ(vertex.number, 3);
  EXPECT_EQ(vertex.tag->name, "VERTEX_SE2");
  EXPECT_TRUE(vertex.is_numeric);
  EXPECT_THAT(vertex.fields.values, ElementsAre(7, 1, 0.5, -3));
  EXPECT_EQ(vertex.fields.integers, 2u);
  EXPECT_FALSE(block.lines()[2].is_numeric);
  EXPECT_EQ(block.lines()[3].kind, Line::Kind::kFix);
  EXPECT_EQ(block.lines()[4].kind, Line::Kind::kUnknown);
}

TEST(LineBlock, FindsRenamedTags) {
  LineBlock block;
  const Renames renames{{"POSE", "VERTEX_SE2"}};
  block.read(TextSource("POSE 7 1 0.5 -3", "g"), 0, {default_registry(), renames});
  EXPECT_EQ(block.lines().at(0).tag->name, "VERTEX_SE2");
}

}  // namespace
}  // namespace boxplus
