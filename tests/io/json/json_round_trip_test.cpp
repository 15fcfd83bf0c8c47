// SPDX-License-Identifier: BSD-3-Clause
// What a graph has is the same after it is written as JSON and read again.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "boxplus/boxplus.h"
#include "boxplus/robust/barron.h"
#include "boxplus/robust/huber.h"
#include "boxplus/robust/kernel_table.h"
#include "boxplus/robust/redescending.h"
#include "boxplus/types/slam2d.h"
#include "boxplus/types/slam3d.h"
#include "io/json/json_registry.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string as_json(const GraphFile& file) {
  return format_graph(file, {.format = "json"});
}

std::string as_g2o(const GraphFile& file) {
  return format_graph(file, {.format = "g2o"});
}

/// The file after it was written as JSON and read again. Checks that a second round changes nothing.
GraphFile round_trip(const GraphFile& file) {
  const std::string text = as_json(file);
  GraphFile again = parse_graph(text, "g.json");
  EXPECT_EQ(again.format, "json");
  EXPECT_EQ(as_json(again), text);
  return again;
}

class JsonOfEveryTag : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Library, JsonOfEveryTag, testing::ValuesIn(json_registry().names()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), ':', '_');
                           return name;
                         });

/// Tags of bundle adjustment and of inertial sensors are only in JSON. As lines, they are written with the
/// registry of JSON.
TEST_P(JsonOfEveryTag, GivesTheSameG2oFile) {
  const Registry& registry = json_registry();
  const GraphFile file = parse_graph(registry.example(GetParam()), "g.g2o", {.registry = &registry});
  EXPECT_TRUE(file.kept.empty());
  const WriteOptions as_lines{.registry = &registry, .format = "g2o"};
  EXPECT_EQ(format_graph(round_trip(file), as_lines), format_graph(file, as_lines));
}

TEST(JsonRoundTrip, GivesTheSameBalFile) {
  const std::string bal = "1 2 2\n0 0 1.5 2\n0 1 -3 0.25\n0.1 2 -0.3 1 2 3 500 -0.1 0.01\n1 2 -10\n3 4 -8\n";
  const GraphFile file = parse_graph(bal, "g.bal");
  const GraphFile again = round_trip(file);
  EXPECT_EQ(format_graph(again, {.format = "BAL"}), format_graph(file));
  EXPECT_EQ(again.graph.chi2(), file.graph.chi2());
}

TEST(JsonRoundTrip, GivesTheSameG2oFilesForRealGraphs) {
  const char* folder = std::getenv("BOXPLUS_DATA");
  if (folder == nullptr || !std::filesystem::is_directory(folder)) GTEST_SKIP() << "no BOXPLUS_DATA";
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".g2o") && !path.ends_with(".graph")) continue;
    ++count;
    const GraphFile file = read_graph(path);
    EXPECT_TRUE(as_g2o(round_trip(file)) == as_g2o(file)) << path;
  }
  if (count == 0) GTEST_SKIP() << "no graphs in BOXPLUS_DATA";
}

TEST(JsonRoundTrip, KeepsTheAttributesOfVertices) {
  GraphFile file;
  Graph& graph = file.graph;
  const auto offset = graph.add_parameter(SE3(), 3);
  const auto fixed_offset = graph.add_parameter(SE2(1, 2, 3), 4);
  const auto a = graph.add_vertex(SE3(), 3), b = graph.add_vertex(SE3(), 7);
  const auto p = graph.add_vertex(Vector3(1, 2, 3), 8);
  graph.unfix(offset);
  graph.fix(a);
  graph.fix_directions(a, {5});
  graph.fix_directions(b, {2, 3, 4});
  graph.set_bounds(p, 2, -0.1, std::numeric_limits<double>::infinity());
  graph.set_bounds(p, 0, 1e-17, 1.5);
  graph.set_eliminated(p, true);
  const GraphFile again = round_trip(file);
  const auto vertex = [&](Id id) { return *again.graph.find_vertex(id); };
  EXPECT_FALSE(again.graph.is_fixed(*again.graph.find_parameter(3)));
  EXPECT_TRUE(again.graph.is_fixed(*again.graph.find_parameter(4)));
  EXPECT_EQ(again.graph.estimate(again.graph.parameter<SE2>(4)).theta(),
            graph.estimate(fixed_offset).theta());
  EXPECT_TRUE(again.graph.is_fixed(vertex(3)));
  EXPECT_THAT(again.graph.fixed_directions(vertex(3)), ElementsAre(5));
  EXPECT_FALSE(again.graph.is_fixed(vertex(7)));
  EXPECT_THAT(again.graph.fixed_directions(vertex(7)), ElementsAre(2, 3, 4));
  EXPECT_FALSE(again.graph.is_eliminated(vertex(7)));
  EXPECT_TRUE(again.graph.is_eliminated(vertex(8)));
  EXPECT_TRUE(std::ranges::equal(again.graph.bounds(vertex(8)), graph.bounds(p)));
}

TEST(JsonRoundTrip, KeepsTheAttributesOfEdges) {
  GraphFile file;
  Graph& graph = file.graph;
  const auto a = graph.add_vertex(SE2(), 0), b = graph.add_vertex(SE2(1, 0, 0), 1);
  const auto plain = graph.add_edge(Between<SE2>(SE2(1, 0, 0.1)), a, b);
  const auto other = graph.add_edge(Between<SE2>(SE2(1, 0, 0.2)), Information(0.1), a, b);
  graph.set_kernel(other, Huber(0.3));
  graph.set_level(other, -4);
  graph.set_enabled(other, false);
  file.edges = {plain, other};
  const GraphFile again = round_trip(file);
  ASSERT_EQ(again.edges.size(), 2u);
  EXPECT_EQ(again.graph.kernel(again.edges[0]), nullptr);
  EXPECT_EQ(again.graph.level(again.edges[0]), 0);
  EXPECT_TRUE(again.graph.is_enabled(again.edges[0]));
  EXPECT_EQ(again.graph.kernel(again.edges[1])->name(), "Huber");
  EXPECT_EQ(again.graph.kernel(again.edges[1])->delta(), 0.3);
  EXPECT_EQ(again.graph.level(again.edges[1]), -4);
  EXPECT_FALSE(again.graph.is_enabled(again.edges[1]));
  EXPECT_EQ(again.graph.information(again.edges[1]).kind, graph.information(other).kind);
  EXPECT_EQ(again.graph.chi2(), graph.chi2());
}

TEST(JsonRoundTrip, KeepsEveryKernel) {
  for (const detail::KernelEntry& entry : detail::kernel_table()) {
    GraphFile file;
    const auto a = file.graph.add_vertex(Vector2(3, 4));
    const auto edge = file.graph.add_edge(Prior<Vector2>(Vector2(0, 0)), a);
    const std::string name = entry.takes_parameter() ? "Barron:-1.3" : std::string(entry.name);
    file.graph.set_kernel(edge, make_robust_kernel(name, 0.7));
    EXPECT_EQ(round_trip(file).graph.chi2(), file.graph.chi2()) << name;
  }
}

TEST(JsonRoundTrip, KeepsTheExtremeShapesOfBarronsKernel) {
  for (const char* name : {"Barron:-inf", "Barron:inf", "Barron:2"}) {
    GraphFile file;
    const auto edge =
        file.graph.add_edge(Prior<Vector2>(Vector2(0, 0)), file.graph.add_vertex(Vector2(3, 4)));
    file.graph.set_kernel(edge, make_robust_kernel(name, 0.7));
    const GraphFile again = round_trip(file);
    const auto& kernel = dynamic_cast<const Barron&>(*again.graph.kernel(again.edges.at(0)));
    EXPECT_EQ(kernel.shape(), dynamic_cast<const Barron&>(*file.graph.kernel(edge)).shape());
  }
}

TEST(JsonRoundTrip, SharesEqualKernels) {
  GraphFile file;
  const auto a = file.graph.add_vertex(Vector2(3, 4));
  for (int i = 0; i < 2; ++i)
    file.graph.set_kernel(file.graph.add_edge(Prior<Vector2>(Vector2(0, 0)), a), Cauchy(2));
  const GraphFile again = round_trip(file);
  EXPECT_EQ(again.graph.kernel(again.edges.at(0)), again.graph.kernel(again.edges.at(1)));
}

TEST(JsonRoundTrip, KeepsLinesThatAreNotInTheGraph) {
  const GraphFile file = parse_graph(
      "# a \"comment\" \\ with\ttab and \xE2\x8A\x9E\nVERTEX_SE2 0 0 0 0\nROBOTLASER1 0 1  2 \x01\n# "
      "B\xFCro\n"
      "VERTEX_SE2 1 1 0 0\n# before the edges\nEDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nODD LINE\n",
      "g");
  const std::string text = as_json(file);
  EXPECT_THAT(text, HasSubstr(R"({"text": "# a \"comment\" \\ with\u0009tab and )"
                              "\xE2\x8A\x9E\"}"));
  EXPECT_THAT(text, HasSubstr(R"({"after_vertex": 0, "text": "ROBOTLASER1 0 1  2 \u0001"})"));
  EXPECT_THAT(text, HasSubstr(R"({"after_vertex": 0, "bytes": [35, 32, 66, 252, 114, 111]})"));
  EXPECT_THAT(text, HasSubstr(R"({"after_edge": -1, "text": "EDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1"})"));
  EXPECT_THAT(text, HasSubstr(R"({"after_edge": 0, "text": "ODD LINE"})"));
  const GraphFile again = round_trip(file);
  EXPECT_EQ(as_g2o(again), as_g2o(file));
  ASSERT_EQ(again.notes.size(), file.notes.size());
  EXPECT_EQ(again.notes[0].text, file.notes[0].text);
}

TEST(JsonRoundTrip, KeepsLinesNextToTheSameEdgesIfOthersAreRemoved) {
  GraphFile file = parse_graph(
      "VERTEX_XY 0 0 0\nEDGE_PRIOR_XY 0 1 0 1 0 1\n# one\nEDGE_PRIOR_XY 0 2 0 1 0 1\n# two\n"
      "EDGE_PRIOR_XY 0 3 0 1 0 1\n# three\n",
      "g");
  file.graph.remove(file.edges[1]);
  EXPECT_EQ(as_g2o(round_trip(file)), as_g2o(file));
}

TEST(JsonRoundTrip, KeepsIdsThatADoubleCannotHold) {
  GraphFile file;
  constexpr Id kLargest = 9223372036854775807, kOdd = 9007199254740993;
  const auto a = file.graph.add_vertex(SE2(), kLargest), b = file.graph.add_vertex(SE2(), kOdd);
  file.graph.add_edge(Between<SE2>(SE2(1, 0, 0)), a, b);
  const GraphFile again = round_trip(file);
  EXPECT_EQ(as_g2o(again), as_g2o(file));
  EXPECT_TRUE(again.graph.find_vertex(kLargest).has_value());
}

TEST(JsonRoundTrip, HoldsAnEmptyGraph) {
  EXPECT_EQ(as_json({}),
            "{\"format\": \"boxplus graph\", \"version\": 1,\n\"parameters\": [],\n\"vertices\": [],\n"
            "\"edges\": [],\n\"kept\": []}\n");
  EXPECT_EQ(round_trip({}).graph.vertex_count(), 0u);
}

}  // namespace
}  // namespace boxplus
