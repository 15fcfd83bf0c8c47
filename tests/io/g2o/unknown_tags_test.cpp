// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/unknown_tags.h"

#include <gmock/gmock.h>

#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

TEST(UnknownTags, AreMentionedIfTheirLineMayDefineTheMissingVertex) {
  EXPECT_EQ(
      complaint("VERTEX_XY 7 2 3\nVERTEX_ROOM 4 0 0 0 1 500\nEDGE_SE2_XY 4 7 2 3 1 0 1\n"),
      "g:3:13: expected the id of a vertex, but there is no vertex 4; line 2 has that id after the unknown "
      "tag 'VERTEX_ROOM'");
  EXPECT_THAT(complaint("VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nPARAMS_CAMERA 5 1 0 0\n"
                        "EDGE_SE2_POINTXY_OFFSET 0 1 5 2 0 1 0 1\n"),
              HasSubstr("there is no parameter 5; line 3 has that id after the unknown tag 'PARAMS_CAMERA'"));
  EXPECT_THAT(complaint("VERTEX_ROOM 4 0 0 0 1 500\nVERTEX_XY 7 2 3\nFIX 4\n"), HasSubstr("'VERTEX_ROOM'"));
}

TEST(UnknownTags, AreNotMentionedIfNoLineCanDefineTheMissingVertex) {
  EXPECT_THAT(
      complaint(
          "VERTEX_XY 7 2 3\nVERTEX_ROOM 5 0\nEDGE_ROOM 4 7 1\nVERTEX_ROOM\nEDGE_SE2_XY 4 7 2 3 1 0 1\n"),
      testing::EndsWith("there is no vertex 4"));
}

TEST(UnknownTags, GetOneNotePerTagAndTheirLinesAreKept) {
  const GraphFile file = parse_graph("VERTEX_SE2 0 0 0 0\nSCAN x y\nSCAN z\n", "g");
  EXPECT_THAT(file.kept, SizeIs(2));
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_THAT(file.notes[0].text, HasSubstr("2 lines with the unknown tag 'SCAN'"));
}

}  // namespace
}  // namespace boxplus
