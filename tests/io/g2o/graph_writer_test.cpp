// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <filesystem>
#include <tuple>

#include "boxplus/boxplus.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"

namespace boxplus {
namespace {

/// A file in the order in which the writer writes: parameters, vertices by id with their FIX lines and data,
/// then edges. Edges of several types alternate.
constexpr const char* kCanonical =
    "PARAMS_SE2OFFSET 5 1 0 0.25\n"
    "PARAMS_SE3OFFSET 6 0 0 1 0 0 0 1\n"
    "VERTEX_SE2 0 0 0 0\n"
    "FIX 0\n"
    "VERTEX_SE2 1 1 0.1 0.5\n"
    "ROBOTLASER1 1 2 3 some  text\n"
    "VERTEX_XY 2 2 3\n"
    "VERTEX_SE3:QUAT 3 1 2 3 0 0 0 1\n"
    "VERTEX_TRACKXYZ 4 1 1 1\n"
    "VERTEX_ODOM_DIFFERENTIAL 8 1 1 0.5\n"
    "VERTEX_SE3:QUAT 9 1 2 3.5 0 0 0.6 0.8\n"
    "EDGE_SE2_XY 0 2 2 3 1 0 1\n"
    "EDGE_SE2 0 1 1 0 0.5 1 0.5 0 2 0 3\n"
    "ODD LINE\n"
    "EDGE_SE2_XY 1 2 1 1 1 0 1\n"
    "EDGE_SE2_POINTXY_OFFSET 1 2 5 1 1 1 0 1\n"
    "EDGE_SE2_OFFSET 0 1 5 5 1 0 0.5 1 0 0 1 0 1\n"
    "EDGE_SE2_ODOM_DIFFERENTIAL_CALIB 0 1 8 1 2 0.1 1 0 0 1 0 1\n"
    "EDGE_SE2_LOTSOFXY 0 2 || 1 2 3 1 0 1\n"
    "EDGE_BEARING_SE2_XY 0 2 0.5 100\n"
    "EDGE_PRIOR_SE2 1 1 0 0.5 1 0 0 1 0 1\n"
    "EDGE_PRIOR_SE2_XY 1 1 0 1 0 1\n"
    "EDGE_PRIOR_XY 2 1 0 1 0 1\n"
    "EDGE_SE3:QUAT 3 9 0 0 0.5 0 0 0.6 0.8 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 4 0 0 4 0 4\n"
    "EDGE_SE3_TRACKXYZ 3 4 6 0 0 0 1 0 0 1 0 1\n"
    "EDGE_SE3_XYZ_PRIOR 3 6 0 0 0 1 0 0 1 0 1\n"
    "EDGE_POINTXYZ_PRIOR 4 0 0 0 1 0 0 1 0 1\n";

std::string temporary(const char* name) {
  return (std::filesystem::temp_directory_path() / (std::string("boxplus_writer_test_") + name)).string();
}

TEST(GraphWriter, WritesAFileByteForByteIfItIsInTheOrderOfTheWriter) {
  EXPECT_EQ(format_graph(parse_graph(kCanonical, "g")), kCanonical);
}

TEST(GraphWriter, KeepsCommentsAndUnknownLinesNextToTheSameElements) {
  const std::string text =
      "# about this file\n"
      "VERTEX_SE2 0 0 0 0\n"
      "ROBOTLASER1 0 -1.57 3.14  180\n"
      "# two scans\n"
      "ROBOTLASER1 0 -1.57 3.14  181\n"
      "VERTEX_SE2 1 1 0 0\n"
      "FIX 1\n"
      "SCAN of 1\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 -1 1 0 0 1 0 0 1 0 1\n"
      "MATCH 0.7\n"
      "EDGE_SE2 1 0 -1 0 0 1 0 0 1 0 1\n"
      "# the end\n";
  EXPECT_EQ(format_graph(parse_graph(text, "g")), text);
  const std::string mixed =
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nMATCH 1\nVERTEX_SE2 1 1 0 0\nSCAN of 1\nVERTEX_SE2 0 0 0 0\nSCAN of "
      "0\n";
  EXPECT_EQ(format_graph(parse_graph(mixed, "g")),
            "VERTEX_SE2 0 0 0 0\nSCAN of 0\nVERTEX_SE2 1 1 0 0\nSCAN of 1\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 "
            "1\nMATCH 1\n");
}

TEST(GraphWriter, KeepsUnknownLinesInPlaceIfAnEdgeBeforeThemWasRemoved) {
  GraphFile file = parse_graph(
      "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nMATCH 1\nEDGE_SE2 1 0 -1 0 0 "
      "1 0 0 1 0 "
      "1\n",
      "g");
  file.graph.remove(file.edges[0]);
  EXPECT_EQ(format_graph(file),
            "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0\nMATCH 1\nEDGE_SE2 1 0 -1 0 0 1 0 0 1 0 1\n");
}

TEST(GraphWriter, WritesNewEdgesAfterTheEdgesOfTheFile) {
  GraphFile file = parse_graph("VERTEX_XY 0 0 0\nVERTEX_XY 1 1 0\nEDGE_POINTXY 0 1 1 0 1 0 1\n", "g");
  file.graph.add_edge(Prior(Vector2(0.5, 0)), 2.0, file.graph.vertex<Vector2>(0));
  EXPECT_THAT(format_graph(file),
              testing::EndsWith("EDGE_POINTXY 0 1 1 0 1 0 1\nEDGE_PRIOR_XY 0 0.5 0 2 0 2\n"));
}

TEST(GraphWriter, WritesAnOptimizedGraphThatIsReadBackBitForBit) {
  Simulation simulation = simulate(World::kSphere, {.poses = 100, .seed = 7});
  std::ignore = optimize(simulation.graph);
  const std::string path = temporary("sphere.g2o");
  write_graph(path, simulation.graph);
  const GraphFile again = read_graph(path);
  for (const VertexRef& vertex : simulation.graph.all_vertices()) {
    const Id id = simulation.graph.id(vertex);
    EXPECT_EQ(again.graph.estimate(again.graph.vertex<SE3>(id)).vector(),
              simulation.graph.estimate(simulation.graph.vertex<SE3>(id)).vector());
  }
  EXPECT_EQ(again.graph.chi2(), simulation.graph.chi2());
  std::filesystem::remove(path);
}

TEST(GraphWriter, ReportsTheTypeThatHasNoTag) {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2(1, 0, 0));
  graph.add_edge(Range(1), a, b);
  try {
    write_graph(temporary("never.g2o"), graph);
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("edges of type Range"));
  }
  EXPECT_FALSE(std::filesystem::exists(temporary("never.g2o")));
}

}  // namespace
}  // namespace boxplus
