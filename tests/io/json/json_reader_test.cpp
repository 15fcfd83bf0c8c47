// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/registry.h"
#include "boxplus/types/slam2d.h"
#include "io/complaint.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string kHead = "{\"format\": \"boxplus graph\", \"version\": 1,\n";
constexpr const char* kVertices =
    "\"vertices\": [{\"tag\": \"VERTEX_SE2\", \"id\": 0, \"fields\": [0, 0, 0]},\n"
    "{\"tag\": \"VERTEX_SE2\", \"id\": 1, \"fields\": [1, 0, 0]}]";
constexpr const char* kEdge =
    R"({"tag": "EDGE_SE2", "ids": [0, 1], "fields": [1, 0, 0.5], "information": [1, 0, 0, 1, 0, 1]})";

/// A graph with one vertex, whose object is on line 2 from column 15 on.
std::string with_vertex(const std::string& vertex) {
  return kHead + "\"vertices\": [ " + vertex + "]}";
}

/// A graph with the vertices 0 and 1, and an edge on line 4.
std::string with_edge(const std::string& edge) {
  return kHead + kVertices + ",\n\"edges\": [\n" + edge + "]}";
}

std::string with_kept(const std::string& line) {
  return kHead + kVertices + ",\n\"edges\": [" + kEdge + "], \"kept\": [\n" + line + "]}";
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

std::string edge_with(const std::string& part, const std::string& by) {
  return with_edge(replaced(kEdge, part, by));
}

TEST(JsonReader, AcceptsMembersInAnyOrderAndAnyBlanks) {
  const std::string expected = format_graph(parse_graph(with_edge(kEdge), "g"));
  const std::string edge =
      "\n{\r\n\"information\":[1,0,0,1,0,1],\t\"ids\":[0,1.0] ,\"fields\" : [ 1.0,0e0,5E-1 ],"
      "\"tag\":\"EDGE\\u005fSE2\"}\n";
  EXPECT_EQ(format_graph(parse_graph(
                " \n" + kHead + "\"edges\":[" + edge + "],\"parameters\":[]," + kVertices + "}\n\n", "g")),
            expected);
  EXPECT_EQ(format_graph(parse_graph("\xEF\xBB\xBF{\"edges\":[" + edge + "]," + kVertices +
                                         ",\"version\":1e0,\"format\":\"boxplus graph\"}",
                                     "g")),
            expected);
}

TEST(JsonReader, ReadsKeptLinesThatComeFirst) {
  const GraphFile file =
      parse_graph(kHead + "\"kept\": [{\"after_edge\": 0, \"text\": \"# end\"}], \"edges\": [" + kEdge +
                      "], " + kVertices + "}",
                  "g");
  EXPECT_THAT(format_graph(file, {.format = "g2o"}), HasSubstr("0 1 1 0 0.5 1 0 0 1 0 1\n# end\n"));
}

TEST(JsonReader, RecognizesAnyObject) {
  const FileFormats& formats = default_formats();
  EXPECT_EQ(formats.recognize("{}")->name, "json");
  EXPECT_EQ(formats.recognize("\xEF\xBB\xBF \n{\n\"a")->name, "json");
  EXPECT_EQ(formats.recognize("{ VERTEX_SE2")->name, "g2o");
  EXPECT_EQ(formats.recognize("[1]")->name, "g2o");
}

TEST(JsonReader, FindsThePlaceInALongTextAcrossItsPieces) {
  std::string text = kHead + "\"vertices\": [";
  constexpr std::size_t kCount = 20'000;  // more than a megabyte
  for (std::size_t i = 0; i < kCount; ++i) {
    text += i == 0 ? "\n" : ",\n";
    text +=
        "{\"tag\": \"VERTEX_XY\", \"id\": " + std::to_string(i) + ", \"fields\": [0.12345678901234567, -1]}";
  }
  EXPECT_EQ(parse_graph(text + "]}", "g").graph.vertex_count(), kCount);
  EXPECT_EQ(parse_graph(text + "]}", "g").lines, std::int64_t{kCount} + 2);
  EXPECT_THAT(complaint(text + ", {\"tag\": 1}]}"), StartsWith("g:20002:"));
  EXPECT_EQ(complaint(text), "g:20002:" + std::to_string(text.size() - text.rfind('\n')) +
                                 ": expected a comma or ], got the end of the text");
  const std::string blanks(std::size_t{1} << 20, ' ');  // one line
  EXPECT_EQ(complaint(kHead + blanks + "x"),
            "g:2:1048577: expected the name of a member (a string), got 'x'");
}

TEST(JsonReader, NotesNormalizedQuaternionsWithTheirLine) {
  const GraphFile file = parse_graph(
      with_vertex("\n{\"tag\": \"VERTEX_SE3:QUAT\", \"id\": 1, \"fields\": [0, 0, 0, 0, 0, 0, 1.0005]}"),
      "g");
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0].line, 3);
}

TEST(JsonReader, ReadsAnyTagThatAnotherOneIsRenamedTo) {
  ReadOptions options;
  options.renames = {{"VERTEX_CAM", "VERTEX_SE2"}};
  EXPECT_EQ(parse_graph(with_vertex(R"({"tag": "VERTEX_CAM", "id": 1, "fields": [1, 2, 3]})"), "g", options)
                .graph.vertex_count(),
            1u);
}

TEST(JsonReader, NamesThePlaceOfEachError) {
  const auto vertex = [](const std::string& members) { return complaint(with_vertex("{" + members + "}")); };
  EXPECT_EQ(vertex(R"("id": 1, "fields": [1, 2, 3])"), "g:2:15: expected an element with tag");
  EXPECT_EQ(vertex(R"("tag": "NONE", "id": 1, "fields": [])"),
            "g:2:23: expected the tag of a vertex, got 'NONE', which is unknown");
  EXPECT_EQ(vertex(R"("tag": "EDGE_SE2", "id": 1, "fields": [])"),
            "g:2:23: expected the tag of a vertex, got 'EDGE_SE2'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX2", "id": 1, "fields": [])"),
            "g:2:23: expected the tag of a vertex, got 'VERTEX2', which is a tag of old files");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": -1, "fields": [1, 2])"),
            "g:2:42: expected an id ≥ 0, got -1");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1.5, "fields": [1, 2])"),
            "g:2:42: expected an id (an integer), got '1.5'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1e30, "fields": [1, 2])"),
            "g:2:42: expected an id (an integer), got '1e30'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1])"),
            "g:2:57: expected a coordinate, got the end of the list");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2, 3])"),
            "g:2:62: expected the end of the list, got '3'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, "two"])"),
            "g:2:60: expected a coordinate (a finite number), got 'two'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 1e999])"),
            "g:2:59: expected a number (a finite number), got '1e999'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, null])"),
            "g:2:59: expected a number, got 'null'");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "fixed": 1)"),
            "g:2:72: expected whether the vertex is fixed (true or false), got '1'");
  EXPECT_THAT(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "fixed_directions": [2])"),
              StartsWith("g:2:83: "));
  EXPECT_THAT(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "level": 1)"),
              HasSubstr("g:2:63: expected one of the members tag, id, fields, fixed, fixed_directions, "
                        "bounds, eliminated, got 'level'"));
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "bounds": [{"entry": 0}])"),
            "g:2:74: expected a bound with entry, and with lower, upper or both");
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "bounds": [{"entry": 0, "most": 1}])"),
            "g:2:87: expected one of the members entry, lower, upper, got 'most'");
  EXPECT_THAT(
      vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "bounds": [{"entry": 2, "lower": 1}])"),
      HasSubstr("g:2:73: set_bounds(): expected an entry from 0 to 1, got 2"));
  EXPECT_EQ(vertex(R"("tag": "VERTEX_XY", "id": 1, "fields": [1, 2], "id": 2)"),
            "g:2:63: expected the member 'id' only once");
}

TEST(JsonReader, NamesThePlaceOfErrorsOfEdges) {
  EXPECT_EQ(complaint(edge_with("[0, 1]", "[0]")), "g:5:28: expected 2 ids, got 1");
  EXPECT_EQ(complaint(edge_with("[0, 1]", "[0, 2]")),
            "g:5:32: expected the id of a vertex, but there is no vertex 2");
  EXPECT_EQ(complaint(edge_with("[0, 1]", "[0, -1]")), "g:5:28: expected the ids of vertices, got −1");
  EXPECT_THAT(complaint(edge_with("[0, 1]", "[1, 1]")), HasSubstr("but vertex 1 appears twice"));
  EXPECT_EQ(complaint(edge_with("0, 1]}", "0, 1, 7]}")), "g:5:93: expected the end of the list, got '7'");
  EXPECT_THAT(complaint(edge_with("[1, 0, 0, 1, 0, 1]", "[1, 0, 0, 1, 0, -1]")), StartsWith("g:5:75: "));
  EXPECT_THAT(complaint(edge_with("1]}", R"(1], "kernel": {"name": "None", "width": 1}})")),
              HasSubstr("unknown robust kernel 'None'"));
  EXPECT_THAT(complaint(edge_with("1]}", R"(1], "kernel": {"name": "Huber", "width": 0}})")),
              HasSubstr("expected a finite width > 0"));
  EXPECT_THAT(complaint(edge_with("1]}", R"(1], "kernel": {"name": "Huber"}})")),
              HasSubstr("expected a kernel with name and width"));
  EXPECT_THAT(complaint(edge_with("1]}", R"(1], "level": 3000000000})")),
              HasSubstr("expected a level (an integer of 32 bits), got 3000000000"));
}

TEST(JsonReader, NamesTheNumberOfFieldsIfItIsWrongWhateverTheInformationWouldThenBe) {
  const auto edge = [](const std::string& fields, const std::string& information) {
    return complaint(edge_with("[1, 0, 0.5], \"information\": [1, 0, 0, 1, 0, 1]",
                               fields + ", \"information\": " + information));
  };
  EXPECT_EQ(edge("[1, 0]", "[1, 0, 0, 1, 0, 1]"), "g:5:46: expected 3 fields, got 2");
  EXPECT_EQ(edge("[1, 0, 0.5, -2]", "[1, 0, 0, 1, 0, 1]"), "g:5:46: expected 3 fields, got 4");
  EXPECT_EQ(edge("[1, 0, 0.5, 1]", "[0, 0, 1, 0, 1]"), "g:5:46: expected 3 fields, got 4");
  EXPECT_EQ(edge("[1, 0, 0.5, 0]", "[0, 0, 0, 0, 0, 1]"), "g:5:46: expected 3 fields, got 4");
  const std::string lots = default_registry().example("EDGE_SE2_LOTSOFXY");
  const std::string text = format_graph(parse_graph(lots, "g"), {.format = "json"});
  EXPECT_THAT(complaint(replaced(text, "\"fields\": [2, 1, 2, 3, 4]", "\"fields\": [2, 1, 2, 3, 4, 5]")),
              HasSubstr("expected 5 fields, got 6"));
  const std::string poses =
      format_graph(parse_graph("VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nVERTEX_SE3:QUAT 1 0 0 0 0 0 0 1\n"
                               "EDGE_SE3:QUAT 0 1 5 6 7 0 0 0 1 9 0 0 0 0 0 9 0 0 0 0 9 0 0 0 9 0 0 9 0 9\n",
                               "g"),
                   {.format = "json"});
  EXPECT_THAT(complaint(replaced(poses, "[5, 6, 7, 0, 0, 0, 1]", "[5, 6, 7, 0, 0, 0]")),
              HasSubstr("expected more than 6 fields"));
}

TEST(JsonReader, RefusesKeptLinesThatWouldBePartOfTheGraph) {
  EXPECT_THAT(complaint(with_kept(R"({"text": "VERTEX_SE2 3 0 0 0"})")),
              HasSubstr(":1: expected a line that is not part of the graph, got VERTEX_SE2"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "\uFEFFVERTEX_SE2 3 0 0 0"})")), HasSubstr("got VERTEX_SE2"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "FIX 0"})")), HasSubstr("got FIX"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1"})")),
              HasSubstr("got EDGE_SE2"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "# a\nVERTEX_SE2 3 0 0 0"})")), HasSubstr("a single line"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "# a", "after_vertex": 2})")),
              HasSubstr("there is no vertex 2"));
  EXPECT_THAT(complaint(with_kept(R"({"text": "# a", "after_edge": 1})")), HasSubstr("(-1 … 0), got 1"));
  EXPECT_THAT(complaint(with_kept(R"({"bytes": [35, 256]})")),
              HasSubstr("expected a byte (0 … 255), got 256"));
  EXPECT_THAT(complaint(with_kept(R"({"after_edge": 0})")), HasSubstr("a kept line with text or bytes"));
}

TEST(JsonReader, RefusesTextsThatAreNotAGraph) {
  EXPECT_EQ(complaint("{}"),
            "g:1:1: expected a graph with the members \"format\": \"boxplus graph\" and \"version\": 1");
  EXPECT_THAT(complaint("{\"a\": 1}"), HasSubstr("of a boxplus graph, got 'a'"));
  EXPECT_THAT(complaint("{\"format\": \"other\"}"),
              HasSubstr("expected the format 'boxplus graph', got 'other'"));
  EXPECT_THAT(complaint("{\"format\": \"boxplus graph\", \"version\": 2}"),
              HasSubstr("expected version 1 of the format, got 2"));
  EXPECT_EQ(complaint(kHead + "\"edges\": [], \"edges\": []}"),
            "g:2:14: expected the member 'edges' only once");
  EXPECT_THAT(complaint(kHead + "\"edges\": []} 1"), HasSubstr("expected the end of the text"));
}

TEST(JsonReader, RefusesTextsThatAreNotJson) {
  const std::string good = with_edge(kEdge);
  for (std::size_t size = 2; size < good.size(); ++size)
    EXPECT_THAT(complaint(good.substr(0, size)), HasSubstr("expected ")) << good.substr(0, size);
  for (const char* number : {"01", "+1", "1.", ".5", "1e", "-", "0x1", "NaN", "1 2", "1,", "-a", "1\"\""})
    EXPECT_THAT(complaint(replaced(good, "0.5", number)), StartsWith("g:5:5")) << number;
  for (const char* string : {"\"\\x\"", "\"\\u12\"", "\"\\uD800\"", "\"\\uD800\\u0041\"", "\"\\uDC00\"",
                             "\"a\nb\"", "\"\xFF\"", "\"\xC0\x80\"", "\"\xED\xA0\x80\"", "\"\xE2\x82\""})
    EXPECT_THAT(complaint(with_kept("{\"text\": " + std::string(string) + "}")), HasSubstr("expected "));
  EXPECT_THAT(complaint(edge_with("1]}", "1], \"enabled\": tru}")), HasSubstr("(true or false), got 'tru'"));
}

TEST(JsonReader, SkipsWrongElementsIfItIsLenient) {
  const ReadOptions lenient{.lenient = true};
  const std::string text = with_edge("{\"tag\": [[{\"deep\": \"]}\"}]]},\n" + std::string(kEdge) + ",\n" +
                                     replaced(kEdge, "[0, 1]", "[0, 9]") + ",\n" + kEdge);
  const GraphFile file = parse_graph(text, "g", lenient);
  EXPECT_EQ(file.skipped, 2);
  EXPECT_EQ(file.graph.edge_count(), 2u);
  ASSERT_EQ(file.notes.size(), 2u);
  EXPECT_EQ(file.notes[0].line, 5);
  EXPECT_EQ(file.notes[0].column, 9);
  EXPECT_EQ(file.notes[1].line, 7);
  EXPECT_TRUE(file.notes[1].skipped);
}

TEST(JsonReader, CountsSkippedEdgesInThePositionsOfKeptLines) {
  const std::string bad = replaced(kEdge, "[0, 1]", "[0, 9]");
  const GraphFile file = parse_graph(kHead + kVertices + ", \"edges\": [" + kEdge + "," + bad + "," + kEdge +
                                         "], \"kept\": [{\"after_edge\": 2, \"text\": \"# end\"}]}",
                                     "g", {.lenient = true});
  ASSERT_EQ(file.kept.size(), 1u);
  EXPECT_EQ(file.kept[0].after, 1);
}

TEST(JsonReader, LimitsTheDepthOfValuesThatItSkips) {
  const std::string deep = with_vertex("{\"tag\": " + std::string(100'000, '[') + "}");
  EXPECT_THAT([&] { parse_graph(deep, "g", {.lenient = true}); },
              testing::ThrowsMessage<InputError>(HasSubstr("expected at most 32 levels of nesting")));
}

}  // namespace
}  // namespace boxplus
