// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "g2o/stuff/color_macros.h"
#include "g2o/stuff/filesys_tools.h"
#include "g2o/stuff/string_tools.h"
#include "g2o/stuff/tuple_tools.h"

namespace {

using testing::ElementsAre;

TEST(Text, BlanksAreTrimmedAtEitherEnd) {
  EXPECT_EQ(g2o::trim(" \t a b\r\n"), "a b");
  EXPECT_EQ(g2o::trimLeft("  a "), "a ");
  EXPECT_EQ(g2o::trimRight("  a "), "  a");
  EXPECT_EQ(g2o::trim(" \n"), "");
}

TEST(Text, IsSplitAtDelimiters) {
  EXPECT_THAT(g2o::strSplit("a,b;c", ",;"), ElementsAre("a", "b", "c"));
  EXPECT_THAT(g2o::strSplit("a,,b,", ","), ElementsAre("a", "", "b"));
  EXPECT_THAT(g2o::strSplit("", ","), ElementsAre());
}

TEST(Text, CaseIsConvertedAndPrefixAndSuffixAreFound) {
  EXPECT_EQ(g2o::strToUpper("vertex_Se2 ä"), "VERTEX_SE2 ä");
  EXPECT_EQ(g2o::strToLower("EDGE"), "edge");
  EXPECT_TRUE(g2o::strStartsWith("edge_se2", "edge"));
  EXPECT_FALSE(g2o::strStartsWith("ed", "edge"));
  EXPECT_TRUE(g2o::strEndsWith("graph.g2o", ".g2o"));
  EXPECT_FALSE(g2o::strEndsWith("g2o", ".g2o"));
}

TEST(Text, IsFormattedAsByPrintf) {
  EXPECT_EQ(g2o::formatString("%d of %s", 3, "many"), "3 of many");
  std::string text;
  EXPECT_EQ(g2o::strPrintf(text, "%05.1f", 2.5), 5);
  EXPECT_EQ(text, "002.5");
}

TEST(Text, NumbersAreParsedWithoutTrailingText) {
  int i = 7;
  EXPECT_FALSE(g2o::convertString("12x", i));
  EXPECT_EQ(i, 7);
  EXPECT_TRUE(g2o::convertString("12x", i, false));
  EXPECT_EQ(i, 12);
  EXPECT_EQ(g2o::stringToType<double>(" 1.5 "), 1.5);
  EXPECT_THROW(g2o::stringToType<int>("one"), std::runtime_error);
}

TEST(Text, LinesAreReadOneByOne) {
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

TEST(Text, FileNamesAreExpanded) {
  setenv("HOME", "/home/me", 1);
  setenv("G2O_TEST_FOLDER", "maps", 1);
  unsetenv("G2O_TEST_NOTHING");
  EXPECT_EQ(g2o::strExpandFilename("~/$G2O_TEST_FOLDER/${G2O_TEST_FOLDER}2"), "/home/me/maps/maps2");
  EXPECT_EQ(g2o::strExpandFilename("~"), "/home/me");
  EXPECT_EQ(g2o::strExpandFilename("~you/a"), "~you/a");
  EXPECT_EQ(g2o::strExpandFilename("a$G2O_TEST_NOTHING/b$"), "a/b$");
  EXPECT_EQ(g2o::strExpandFilename("${G2O_TEST_FOLDER"), "${G2O_TEST_FOLDER");
}

TEST(FileNames, AreSplitAndJoined) {
  EXPECT_EQ(g2o::getFileExtension("/a.b/c.tar.gz"), "gz");
  EXPECT_EQ(g2o::getFileExtension("/a.b/c"), "");
  EXPECT_EQ(g2o::getPureFilename("/a.b/c.tar.gz"), "/a.b/c.tar");
  EXPECT_EQ(g2o::getPureFilename("/a.b/c"), "/a.b/c");
  EXPECT_EQ(g2o::getBasename("/a.b/c.gz"), "c.gz");
  EXPECT_EQ(g2o::getDirname("/a.b/c.gz"), "/a.b");
  EXPECT_EQ(g2o::getDirname("c.gz"), "");
  EXPECT_EQ(g2o::changeFileExtension("a.g2o", "graph"), "a.graph");
  EXPECT_EQ(g2o::changeFileExtension("a.g2o", ".graph", true), "a.graph");
  EXPECT_EQ(g2o::changeFileExtension("a", "graph"), "a");
  EXPECT_EQ(g2o::changeFileExtension("test.txt", ".dat"), "test.dat");
}

TEST(FileNames, FilesAreFoundByPattern) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "g2o_files";
  std::filesystem::create_directories(folder);
  for (const char* name : {"b.g2o", "a.g2o", "c.txt"}) std::ofstream(folder / name) << "text";
  EXPECT_TRUE(g2o::fileExists((folder / "a.g2o").c_str(), true));
  EXPECT_TRUE(g2o::fileExists(folder.c_str()));
  EXPECT_FALSE(g2o::fileExists(folder.c_str(), true));
  EXPECT_FALSE(g2o::fileExists((folder / "d").c_str()));
  EXPECT_THAT(g2o::getFilesByPattern((folder / "*.g2o").c_str()),
              ElementsAre((folder / "a.g2o").string(), (folder / "b.g2o").string()));
  EXPECT_THAT(g2o::getFilesByPattern((folder / "none*").c_str()), ElementsAre());
  EXPECT_THAT(g2o::getFilesByPattern(folder.string(), std::regex(".*\\.g2o")),
              ElementsAre((folder / "a.g2o").string(), (folder / "b.g2o").string()));
  EXPECT_THAT(g2o::getFilesByPattern(std::string_view(folder.c_str()), std::regex("c")), ElementsAre());
  std::filesystem::remove_all(folder);
}

TEST(Text, TerminalColorsAreEscapeSequences) {
  std::ostringstream out;
  out << CL_RED("stop" << 1) << CL_LIGHTBLUE(2) << CL_BLACK(3) << FG_GREEN << FT_BOLD << FG_NORM;
  EXPECT_EQ(out.str(), "\033[31mstop1\033[0m\033[34m2\033[0m\033[30m3\033[0m\033[32m\033[1m\033[0m");
}

TEST(Text, IsJoinedByADelimiter) {
  const std::vector<int> numbers{1, 2, 3};
  EXPECT_EQ(g2o::strJoin(numbers.begin(), numbers.end(), ", "), "1, 2, 3");
  EXPECT_EQ(g2o::strJoin(std::vector<std::string>{"one"}, ", "), "one");
  EXPECT_EQ(g2o::strJoin(numbers.begin(), numbers.begin(), ", "), "");
}

TEST(Text, FunctionsAcceptStringViews) {
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

TEST(Text, MacrosWriteNamesValuesAndFixedNotation) {
  std::ostringstream out;
  const double half_turn = 3.14159265358979323846;
  out << PVAR(2 * 3) << "; " << PVARA(half_turn) << "; " << FIXED(0.5) << "; " << 0.5;
  EXPECT_EQ(out.str(), "2 * 3 = 6; half_turn = 180deg; 0.500000; 0.5");
}

TEST(Tuples, AnElementIsAccessedByARunTimeIndex) {
  std::tuple<int, double> pair(1, 2.5);
  for (int i = 0; i < 3; ++i) g2o::tuple_apply_i([](auto& x) { x *= 2; }, pair, i);
  EXPECT_EQ(pair, std::make_tuple(2, 5.0));
}

}  // namespace
