// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/vertex_tag.h"

#include <gmock/gmock.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using testing::ElementsAre;

constexpr const char* kFields = "kitchen 1 2 0.5 3 4 9.5 100.25 host 0.125";

TEST(VertexTag, HasTheFieldsOfTheLineInTheirOrder) {
  FieldReader in("g", 1, kFields);
  const VertexTag tag = VertexTag::read(in);
  EXPECT_EQ(tag.name, "kitchen");
  EXPECT_THAT(tag.position, ElementsAre(1, 2, 0.5));
  EXPECT_THAT(tag.robot_pose, ElementsAre(3, 4, 9.5));
  EXPECT_EQ(tag.stamp.timestamp, 100.25);
  EXPECT_EQ(tag.stamp.host, "host");
  EXPECT_EQ(tag.stamp.logger_timestamp, 0.125);
  std::string text;
  FieldWriter out(text);
  tag.write(out);
  EXPECT_EQ(text, kFields);
}

TEST(VertexTag, ReportsTheFieldThatIsWrong) {
  FieldReader in("g", 3, "kitchen 1 2 up");
  try {
    VertexTag::read(in);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "g:3:13: expected the position of a name (a finite number), got 'up'");
  }
}

TEST(VertexTag, IsNotWrittenIfItsNameIsNotOneWord) {
  std::string text;
  FieldWriter out(text);
  VertexTag tag;
  for (const char* name : {"", "living room", "line\nbreak", "tab\t"}) {
    tag.name = name;
    EXPECT_THROW(tag.write(out), InvalidArgument) << name;
  }
}

}  // namespace
}  // namespace boxplus
