// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/graph_file.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"

namespace boxplus {
namespace {

TEST(GraphFile, ReportsTheFileThatCannotBeOpened) {
  try {
    read_graph("/nowhere/graph.g2o");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_STREQ(error.what(), "/nowhere/graph.g2o: cannot be opened: No such file or directory");
  }
  EXPECT_THROW(read_graph("/"), FileError);
}

TEST(GraphFile, IsWrittenAsG2oIfItsExtensionIsUnknownOrReadOnly) {
  const GraphFile file = parse_graph("VERTEX2 0 0 0 0\n", "g");
  for (const char* name : {"boxplus_graph_file_test.txt", "boxplus_graph_file_test.graph"}) {
    const std::string path = testing::TempDir() + name;
    write_graph(path, file);
    EXPECT_EQ(format_graph(read_graph(path)), "VERTEX_SE2 0 0 0 0\n") << name;
    std::filesystem::remove(path);
  }
}

TEST(GraphFile, LosesBoundsInEveryFormatButJson) {
  GraphFile file = parse_graph("VERTEX_XY 0 0 0\nVERTEX_XY 1 0 0\n", "g");
  EXPECT_TRUE(losses("g.g2o", file).empty());
  file.graph.set_bounds(file.graph.all_vertices()[0], 0, 0, 1);
  EXPECT_EQ(losses("g.g2o", file), std::vector<std::string>{"the bounds of 1 vertex"});
  EXPECT_EQ(losses("g.bal", file), std::vector<std::string>{"the bounds of 1 vertex"});
  file.graph.set_bounds(file.graph.all_vertices()[1], 1, 0, 1);
  EXPECT_EQ(losses("g.g2o", file), std::vector<std::string>{"the bounds of 2 vertices"});
  EXPECT_TRUE(losses("g.json", file).empty());
}

TEST(GraphFile, IsWrittenInTheFormatOfItsFileIfItsExtensionIsUnknown) {
  const std::string text = "0 1 0\n1\n2\n3\n";
  const GraphFile file = parse_graph(text, "g");
  EXPECT_EQ(file.format, "BAL");
  const std::string path = testing::TempDir() + "boxplus_graph_file_test_of_bal.txt";
  write_graph(path, file);
  EXPECT_EQ(format_graph(read_graph(path)), text);
  write_graph(path, file.graph);
  EXPECT_EQ(format_graph(read_graph(path)), "VERTEX_TRACKXYZ 0 1 2 3\n") << "a graph of no file";
  std::filesystem::remove(path);
}

TEST(GraphFile, CannotBeWrittenInAnUnknownOrReadOnlyFormat) {
  const auto complaint = [](const char* format) -> std::string {
    try {
      return format_graph(Graph{}, {.format = format});
    } catch (const InvalidArgument& error) {
      return error.what();
    }
  };
  std::string known;
  for (const FileFormat& format : default_formats().all()) known += (known.empty() ? "" : ", ") + format.name;
  EXPECT_EQ(complaint("xml"), "unknown file format 'xml'; known formats: " + known);
  EXPECT_EQ(complaint("iSAM"), "cannot write iSAM's .isam: the format is read-only");
}

TEST(GraphFile, IsCheckedBeforeItIsWrittenInTheFormatInWhichItWasRead) {
  const GraphFile file = parse_graph("VERTEX2 0 0 0 0\nVERTEX_XY 1 2 3\n", "g");
  EXPECT_EQ(file.format, "TORO");
  EXPECT_THROW(require_writable("out.graph", file), InvalidArgument) << "TORO has no points";
}

TEST(GraphFile, IsRefusedIfNoFormatRecognizesItsText) {
  FileFormats formats;
  FileFormat format = *default_formats().find("iSAM");
  formats.add(format);
  try {
    parse_graph("VERTEX_SE2 0 0 0 0\n", "g", {.formats = &formats});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "g:1:1: expected a supported format (iSAM's .isam), got another one");
  }
  EXPECT_THROW(format_graph(Graph{}, {.formats = &formats}), InvalidArgument);
}

}  // namespace
}  // namespace boxplus
