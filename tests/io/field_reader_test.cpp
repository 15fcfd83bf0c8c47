// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/field_reader.h"

#include <gmock/gmock.h>

#include <limits>
#include <string>
#include <vector>

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

TEST(FieldReader, ReadsFieldsSeparatedByAnyKindOfBlank) {
  FieldReader in("file", 1, "  A\t12 -1.5e3 +2\r");
  EXPECT_EQ(in.token("a tag"), "A");
  EXPECT_EQ(in.integer("an id"), 12);
  EXPECT_EQ(in.number("x"), -1500);
  EXPECT_EQ(in.number("y"), 2);
  EXPECT_TRUE(in.at_end());
}

TEST(FieldReader, ReportsThePlaceTheExpectedFieldAndTheActualText) {
  EXPECT_EQ(complaint("  abc 1"), "file:7:3: expected x (a finite number), got 'abc'");
  EXPECT_EQ(complaint("  "), "file:7:3: expected x, got the end of the line");
}

TEST(FieldReader, RefusesTextThatIsNotAFiniteNumber) {
  for (const char* text : {"nan", "inf", "-inf", "1e999", "1.5x", "0x10", "--1", "+-1", "1,5", "+"}) {
    EXPECT_NE(complaint(text), "") << text;
  }
}

TEST(FieldReader, TreatsACommentAsTheEndOfTheLine) {
  FieldReader in("file", 1, "1 # one");
  EXPECT_EQ(in.number("x"), 1);
  EXPECT_NO_THROW(in.expect_end());
}

/// A line whose fields are already converted to numbers.
struct Converted {
  std::string line;
  std::vector<double> values;
  std::size_t integers;
  FieldReader reader() const { return {"file", 7, line, {.values = values, .integers = integers}}; }
};

std::string complaint_of(FieldReader& in, void (*read)(FieldReader&)) {
  try {
    read(in);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(FieldReader, ReadsFieldsThatAreAlreadyConvertedToNumbers) {
  const Converted line{"TAG 3 0.5 -2", {3, 0.5, -2}, 1};
  FieldReader in = line.reader();
  EXPECT_EQ(in.integer("an id"), 3);
  EXPECT_EQ(in.converted(2).size(), 2u);
  EXPECT_TRUE(in.converted(1).empty());
  EXPECT_TRUE(in.at_end());
}

TEST(FieldReader, ContinuesWithTheTextAfterTheConvertedFields) {
  const Converted line{"  TAG 3 0.5\t12345678901234567 4 # odd", {3, 0.5, 12345678901234567., 4}, 1};
  FieldReader in = line.reader();
  EXPECT_EQ(in.integer("an id"), 3);
  EXPECT_EQ(in.number("x"), 0.5);
  EXPECT_EQ(in.integer("a large id"), 12345678901234567);
  EXPECT_FALSE(in.accept("||"));
  EXPECT_EQ(in.number("y"), 4);
  EXPECT_TRUE(in.at_end());
}

TEST(FieldReader, ReportsTheColumnsOfConvertedFields) {
  const Converted line{" TAG 3  0.5 4", {3, 0.5, 4}, 1};
  FieldReader in = line.reader();
  in.integer("an id");
  const FieldPlace place = in.place();
  EXPECT_EQ(complaint_of(in, [](FieldReader& reader) { reader.integer("an id"); }),
            "file:7:9: expected an id (an integer), got '0.5'");
  FieldReader again = line.reader();
  again.converted(2);
  EXPECT_EQ(complaint_of(again, [](FieldReader& reader) { reader.expect_end(); }),
            "file:7:13: expected the end of the line, got '4'");
  EXPECT_EQ(complaint_of(again, [](FieldReader& reader) { reader.number("w"); }),
            "file:7:14: expected w, got the end of the line");
  try {
    again.fail(place, "wrong");
  } catch (const InputError& error) {
    EXPECT_EQ(error.column(), 9);
  }
}

TEST(FieldWriter, WritesTheShortestTextThatReadsBackTheSameNumber) {
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
