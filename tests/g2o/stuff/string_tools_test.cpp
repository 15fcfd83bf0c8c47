// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/string_tools.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "g2o/stuff/filesys_tools.h"

namespace {

using testing::ElementsAre;

TEST(StringTools, TrimWhitespaceAtBothEnds) {
  EXPECT_EQ(g2o::trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(g2o::trimLeft("  a "), "a ");
  EXPECT_EQ(g2o::trimRight("  a "), "  a");
  EXPECT_EQ(g2o::trim(" \n"), "");
}

TEST(StringTools, SplitTextAtDelimiters) {
  EXPECT_THAT(g2o::strSplit("a,b;c", ",;"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(g2o::strSplit("a,,b,", ","), ElementsAre("a", "", "b"));
  EXPECT_THAT(g2o::strSplit("", ","), ElementsAre());
}

TEST(StringTools, ConvertCaseAndFindPrefixesAndSuffixes) {
  EXPECT_EQ(g2o::strToUpper("vertex_Se2 ä"), "VERTEX_SE2 ä");
  EXPECT_EQ(g2o::strToLower("EDGE"), "edge");
  EXPECT_TRUE(g2o::strStartsWith("edge_se2", "edge"));
  EXPECT_FALSE(g2o::strStartsWith("ed", "edge"));
  EXPECT_TRUE(g2o::strEndsWith("graph.g2o", ".g2o"));
  EXPECT_FALSE(g2o::strEndsWith("g2o", ".g2o"));
}

TEST(StringTools, FormatTextLikePrintf) {
  EXPECT_EQ(g2o::formatString("%d of %s", 3, "many"), "3 of many");
  std::string text;
  EXPECT_EQ(g2o::strPrintf(text, "%05.1f", 2.5), 5);
  EXPECT_EQ(text, "002.5");
}

TEST(StringTools, ParseNumbersAndRefuseTrailingTextUnlessItIsAllowed) {
  int i = 7;
  EXPECT_FALSE(g2o::convertString("12x", i));
  EXPECT_EQ(i, 7);
  EXPECT_TRUE(g2o::convertString("12x", i, false));
  EXPECT_EQ(i, 12);
  EXPECT_EQ(g2o::stringToType<double>(" 1.5 "), 1.5);
  EXPECT_THROW(g2o::stringToType<int>("one"), std::runtime_error);
}

TEST(StringTools, ReadLinesOneByOne) {
  std::istringstream in("one two\n\nskipped\nlast");
  std::stringstream line;
  EXPECT_EQ(g2o::readLine(in, line), 7);
  std::string word;
  line >> word >> word;
  EXPECT_EQ(word, "two");
  EXPECT_EQ(g2o::readLine(in, line), 0);
  g2o::skipLine(in);
  EXPECT_EQ(g2o::readLine(in, line), 4);
  EXPECT_EQ(line.str(), "last");
  EXPECT_EQ(g2o::readLine(in, line), -1);
}

TEST(StringTools, ExpandFileNames) {
  setenv("HOME", "/home/me", 1);
  setenv("G2O_TEST_FOLDER", "maps", 1);
  unsetenv("G2O_TEST_NOTHING");
  EXPECT_EQ(g2o::strExpandFilename("~/$G2O_TEST_FOLDER/${G2O_TEST_FOLDER}2"), "/home/me/maps/maps2");
  EXPECT_EQ(g2o::strExpandFilename("~"), "/home/me");
  EXPECT_EQ(g2o::strExpandFilename("~you/a"), "~you/a");
  EXPECT_EQ(g2o::strExpandFilename("a$G2O_TEST_NOTHING/b$"), "a/b$");
  EXPECT_EQ(g2o::strExpandFilename("${G2O_TEST_FOLDER"), "${G2O_TEST_FOLDER");
}

TEST(StringTools, JoinTextWithADelimiter) {
  const std::vector<int> numbers{1, 2, 3};
  EXPECT_EQ(g2o::strJoin(numbers.begin(), numbers.end(), ", "), "1, 2, 3");
  EXPECT_EQ(g2o::strJoin(std::vector<std::string>{"one"}, ", "), "one");
  EXPECT_EQ(g2o::strJoin(numbers.begin(), numbers.begin(), ", "), "");
  EXPECT_EQ(g2o::strJoin(numbers.begin(), numbers.end()), "123");
  EXPECT_EQ(g2o::strJoin(numbers), "123");
  EXPECT_EQ(g2o::strJoin(std::string("abc"), std::string("-")), "a-b-c");
}

TEST(StringTools, AcceptStringViews) {
  const std::string_view view = std::string_view(" Edge.g2o,2 |").substr(0, 11);
  EXPECT_EQ(g2o::trim(view), "Edge.g2o,2");
  EXPECT_EQ(g2o::strToLower(view), " edge.g2o,2");
  EXPECT_THAT(g2o::strSplit(view, ","), ElementsAre(" Edge.g2o", "2"));
  EXPECT_TRUE(g2o::strStartsWith(view, " Edge"));
  EXPECT_TRUE(g2o::strEndsWith(view, std::string_view("2")));
  EXPECT_EQ(g2o::getFileExtension(view), "g2o,2");
  EXPECT_EQ(g2o::changeFileExtension(view, "toro"), " Edge.toro");
  int number = 0;
  EXPECT_TRUE(g2o::convertString(view.substr(10), number));
  EXPECT_EQ(number, 2);
}

}  // namespace
