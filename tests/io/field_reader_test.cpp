// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/field_reader.h"

#include <gmock/gmock.h>

#include <limits>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

std::string complaint(std::string_view line) {
  FieldReader in("file", 7, line);
  try {
    in.number("x");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FieldReader, ReadsFieldsThatAnyBlanksSeparate) {
  FieldReader in("file", 1, "  A\t12 -1.5e3 +2\r");
  EXPECT_EQ(in.word("a word"), "A");
  EXPECT_EQ(in.integer("an id"), 12);
  EXPECT_EQ(in.number("x"), -1500);
  EXPECT_EQ(in.number("y"), 2);
  EXPECT_TRUE(in.at_end());
}

TEST(FieldReader, SaysWhereWhatWasExpectedAndWhatCame) {
  EXPECT_EQ(complaint("  abc 1"), "file:7:3: expected x (a finite number), got 'abc'");
  EXPECT_EQ(complaint("  "), "file:7:3: expected x, got the end of the line");
}

TEST(FieldReader, RefusesWhatIsNoFiniteNumber) {
  for (const char* text : {"nan", "inf", "-inf", "1e999", "1.5x", "0x10", "--1", "+-1", "1,5", "+"}) {
    EXPECT_NE(complaint(text), "") << text;
  }
}

TEST(FieldReader, TakesACommentForTheEnd) {
  FieldReader in("file", 1, "1 # one");
  EXPECT_EQ(in.number("x"), 1);
  EXPECT_NO_THROW(in.expect_end());
}

TEST(FieldWriter, WritesTheShortestTextThatReadsBack) {
  for (double value :
       {0.1, 1.0 / 3, 123456.789012, 1000000.25, 5e-324, std::numeric_limits<double>::max(), -0.0}) {
    std::string text;
    FieldWriter(text).number(value);
    FieldReader in("file", 1, text);
    EXPECT_EQ(in.number("x"), value) << text;
    EXPECT_LE(text.size(), 24u);
  }
  std::string text;
  FieldWriter(text).number(0.1);
  EXPECT_EQ(text, "0.1");
}

}  // namespace
}  // namespace boxplus
