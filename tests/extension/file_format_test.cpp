// SPDX-License-Identifier: BSD-3-Clause
// The library recognizes, reads, writes and lists a custom file format like its own formats. This test
// includes public headers only.
#include "boxplus/io/file_format.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "boxplus/boxplus.h"
#include "boxplus/io/field_reader.h"

namespace {

using namespace boxplus;

constexpr std::string_view kTitle = "id,x,y\n";

/// Reads points in the plane from a table of comma-separated values.
GraphFile read_table(const TextSource& text, const ReadOptions& options) {
  std::string memory;
  std::istringstream lines(std::string(text.text(memory)));
  GraphFile file;
  for (std::string line; std::getline(lines, line);) {
    if (++file.lines == 1) continue;
    std::replace(line.begin(), line.end(), ',', ' ');
    FieldReader in(text.name(), file.lines, line);
    try {
      const Id id = in.integer("an id");
      const double x = in.number("x"), y = in.number("y");
      in.expect_end();
      file.graph.add_vertex(Vector2(x, y), id);
    } catch (const InputError& error) {
      if (!options.lenient) throw;
      ++file.skipped;
    }
  }
  return file;
}

void write_table(const GraphFileView& file, const WriteOptions& /*options*/, TextSink sink) {
  if (file.graph.edge_count() > 0) throw InvalidArgument("table: expected points only, got edges");
  std::string text(kTitle);
  for (const VertexRef& vertex : file.graph.all_vertices()) {
    const Vector2& point = file.graph.estimate(file.graph.typed<Vector2>(vertex));
    std::ostringstream line;
    line << file.graph.id(vertex) << "," << point[0] << "," << point[1] << "\n";
    text += line.str();
  }
  sink(text);
}

FileFormats formats_with_table() {
  FileFormats formats = default_formats();
  formats.add({.name = "table",
               .extension = ".csv",
               .recognize = [](std::string_view beginning) { return beginning.starts_with(kTitle); },
               .read = read_table,
               .write = write_table});
  return formats;
}

class CustomFileFormat : public testing::Test {
 protected:
  const FileFormats formats_ = formats_with_table();
  const ReadOptions reading_{.formats = &formats_};
  const WriteOptions writing_{.formats = &formats_};
};

TEST_F(CustomFileFormat, IsReadIfTheContentOfAFileIsRecognized) {
  const GraphFile file = parse_graph("id,x,y\n0,1,2\n7,3,4.5\n", "t", reading_);
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector2>(7)), Vector2(3, 4.5));
  EXPECT_EQ(parse_graph("VERTEX_XY 0 1 2\n", "t", reading_).graph.vertex_count(), 1u) << "a .g2o file";
  EXPECT_EQ(parse_graph("VERTEX2 0 1 2 0\n", "t", reading_).graph.vertex_count(), 1u) << "a TORO file";
  EXPECT_EQ(parse_graph("id,x,y\n0,1,2\n", "t").graph.vertex_count(), 0u)
      << "the default formats do not include the custom format";
}

TEST_F(CustomFileFormat, IsWrittenIfThePathHasItsExtension) {
  const GraphFile file = parse_graph("VERTEX_XY 3 1 2.5\n", "t", reading_);
  const std::string path = testing::TempDir() + "boxplus_own_file_format_test.csv";
  write_graph(path, file, writing_);
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  EXPECT_EQ(text.str(), "id,x,y\n3,1,2.5\n");
  EXPECT_EQ(format_graph(read_graph(path, reading_), {.formats = &formats_, .format = "g2o"}),
            "VERTEX_XY 3 1 2.5\n");
  std::filesystem::remove(path);
}

TEST_F(CustomFileFormat, IsWrittenIfItsNameIsRequested) {
  const GraphFile file = parse_graph("VERTEX_XY 3 1 2.5\n", "t");
  EXPECT_EQ(format_graph(file, {.formats = &formats_, .format = "table"}), "id,x,y\n3,1,2.5\n");
}

TEST_F(CustomFileFormat, IsWrittenIfTheGraphWasReadInItAndTheExtensionIsUnknown) {
  const GraphFile file = parse_graph("id,x,y\n0,1,2\n", "t", reading_);
  EXPECT_EQ(file.format, "table");
  EXPECT_EQ(format_graph(file, writing_), "id,x,y\n0,1,2\n");
  EXPECT_EQ(format_graph(file), "VERTEX_XY 0 1 2\n")
      << "the default formats do not include the custom format";
}

TEST_F(CustomFileFormat, IsListedAfterTheFormatsOfTheLibrary) {
  std::vector<std::string> labels, expected;
  for (const FileFormat& format : formats_.all()) labels.push_back(format.label());
  for (const FileFormat& format : default_formats().all()) expected.push_back(format.label());
  expected.emplace_back("table's .csv");
  EXPECT_EQ(labels, expected);
  try {
    format_graph(Graph{}, {.formats = &formats_, .format = "tabel"});
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("unknown file format 'tabel'; known formats: g2o, "));
    EXPECT_THAT(error.what(), testing::EndsWith(", table"));
  }
}

TEST_F(CustomFileFormat, ReportsTheLineAndTheColumnOfAnError) {
  try {
    parse_graph("id,x,y\n0,1,2\n1,one,2\n", "t", reading_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "t:3:3: expected x (a finite number), got 'one'");
  }
  EXPECT_EQ(parse_graph("id,x,y\n0,1,2\n1,one,2\n", "t", {.lenient = true, .formats = &formats_}).skipped, 1);
}

}  // namespace
