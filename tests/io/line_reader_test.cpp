// SPDX-License-Identifier: BSD-3-Clause
#include "io/line_reader.h"

#include <gtest/gtest.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

using Tags = std::vector<std::string>;

/// The tags of all lines, each with its number. Refuses lines that do not end after their tag.
Tags tags_of(const TextSource& text, const ReadOptions& options, GraphFile& file) {
  Tags tags;
  read_lines(text, options, file, [&](std::string_view tag, FieldReader& in, std::string_view) {
    in.expect_end();
    tags.push_back(std::to_string(in.line_number()) + ":" + std::string(tag));
  });
  return tags;
}

TEST(ReadLines, SkipsBlankLinesAndCommentsAndCountsAllLines) {
  GraphFile file;
  EXPECT_EQ(tags_of(TextSource("\xEF\xBB\xBF"
                               "A # comment\r\n \n# B\n\n  C",
                               "g"),
                    {}, file),
            (Tags{"1:A", "5:C"}));
  EXPECT_EQ(file.lines, 5);
}

TEST(ReadLines, ReadsTheSameLinesFromBlocksOfAnySize) {
  for (std::size_t size = 1; size < 12; ++size) {
    GraphFile file;
    EXPECT_EQ(tags_of(TextSource("one\n\ntwo\nthree\n", "g", size), {}, file),
              (Tags{"1:one", "3:two", "4:three"}));
    EXPECT_EQ(file.lines, 4);
  }
}

TEST(ReadLines, ThrowsForABadLineOrSkipsItWithANote) {
  const TextSource text("A\nB 1\nC\n", "g");
  GraphFile file;
  EXPECT_THROW(tags_of(text, {}, file), InputError);
  GraphFile lenient;
  EXPECT_EQ(tags_of(text, {.lenient = true}, lenient), (Tags{"1:A", "3:C"}));
  EXPECT_EQ(lenient.skipped, 1);
  ASSERT_EQ(lenient.notes.size(), 1u);
  EXPECT_EQ(lenient.notes[0].line, 2);
  EXPECT_EQ(lenient.notes[0].column, 3);
  EXPECT_TRUE(lenient.notes[0].skipped);
  EXPECT_EQ(lenient.notes[0].text, "expected the end of the line, got '1'");
}

TEST(FirstTag, IsThatOfTheFirstElement) {
  EXPECT_EQ(first_tag("\n # A\n\tB 1\nC\n"), "B");
  EXPECT_EQ(first_tag("A\nB", [](std::string_view tag) { return tag == "A"; }), "B");
  EXPECT_EQ(first_tag("# A\n"), "");
  EXPECT_EQ(first_tag(""), "");
}

TEST(OtherLines, AreCountedByTagWithTheMostFrequentFirst) {
  OtherLines lines;
  std::vector<GraphFile::Note> notes;
  lines.append_note(notes);
  EXPECT_TRUE(notes.empty());
  lines.add("B");
  lines.append_note(notes);
  for (const char* tag : {"A", "C", "C", "D", "E", "F"}) lines.add(tag);
  lines.append_note(notes);
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_EQ(notes[0].text, "1 line is not part of the graph: 1 'B'");
  EXPECT_EQ(notes[1].text, "7 lines are not part of the graph: 2 'C', 1 'A', 1 'B', 1 'D', 1 'E', …");
}

}  // namespace
}  // namespace boxplus
