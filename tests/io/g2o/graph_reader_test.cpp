// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "boxplus/boxplus.h"
#include "boxplus/testing/simulate.h"

namespace boxplus {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* kTwoPoses = "VERTEX_SE2 0 0 0 0\nVERTEX_SE2 1 1 0 0.5\n";

TEST(GraphReader, ReadsPosesLandmarksAndTheirEdges) {
  const GraphFile file = parse_graph(
      "# a comment\n\n   \nVERTEX_SE2 0 0 0 0\r\nFIX 0\nVERTEX_SE2 3 1 0 0.5\nVERTEX_XY 7 2 3\n"
      "EDGE_SE2 0 3 1 0 0.5 1 0 0 2 0 3\nEDGE_SE2_XY 0 7 2 3 1 0 1",
      "g");
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  EXPECT_THAT(file.edges, SizeIs(2));
  EXPECT_TRUE(file.graph.is_fixed(file.graph.vertex<SE2>(0)));
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector2>(7)), Vector2(2, 3));
  EXPECT_EQ(file.graph.information(file.edges[0])(1, 1), 2);
  EXPECT_EQ(file.graph.chi2(), 0);
  EXPECT_THAT(file.notes, IsEmpty());
}

TEST(GraphReader, AcceptsEdgesBeforeTheirVertices) {
  EXPECT_EQ(parse_graph(std::string("EDGE_SE2 0 1 1 0 0.5 1 0 0 1 0 1\n") + kTwoPoses, "g").edges.size(), 1u);
}

TEST(GraphReader, ReadsTheSameGraphWithAnyNumberOfThreads) {
  Simulation simulation = simulate(World::kCity, {.poses = 3000});
  const GraphFile made{.graph = std::move(simulation.graph), .edges = std::move(simulation.edges)};
  const std::string text = format_graph(made);
  ASSERT_GT(text.size(), 3 * 131072u) << "the text must have several blocks";
  for (int threads : {1, 2, 5}) {
    ReadOptions options;
    options.threads = threads;
    EXPECT_EQ(format_graph(parse_graph(text, "g", options)), text);
  }
}

TEST(GraphReader, IgnoresAByteOrderMark) {
  EXPECT_EQ(parse_graph(std::string("\xEF\xBB\xBF") + kTwoPoses, "g").graph.vertex_count(), 2u);
}

TEST(GraphReader, ReadsRenamedTags) {
  ReadOptions options;
  options.renames = {{"POSE", "VERTEX_SE2"}, {"VERTEX_SE2", "VERTEX_XY"}};
  const GraphFile file = parse_graph("POSE 0 0 0 0\nVERTEX_SE2 1 2 3\n", "g", options);
  EXPECT_EQ(file.graph.estimate(file.graph.vertex<Vector2>(1)), Vector2(2, 3));
  EXPECT_EQ(format_graph(file), "VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 2 3\n");
}

TEST(GraphReader, ReadsSensorOffsetsAndAppliesThem) {
  const GraphFile file = parse_graph(
      "PARAMS_SE2OFFSET 5 1 0 0\nVERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nEDGE_SE2_POINTXY_OFFSET 0 1 5 2 0 1 0 "
      "1\n",
      "g");
  EXPECT_EQ(file.graph.parameter_count(), 1u);
  EXPECT_EQ(file.graph.chi2(), 0);
}

TEST(GraphReader, ReadsAnEdgeWithTheSameOffsetAtBothEnds) {
  const GraphFile file = parse_graph(
      std::string(kTwoPoses) + "PARAMS_SE2OFFSET 5 1 0 0\nEDGE_SE2_OFFSET 0 1 5 5 1 0 0.5 1 0 0 1 0 1\n",
      "g");
  EXPECT_THAT(file.graph.vertices(file.edges[0]), SizeIs(3));
}

TEST(GraphReader, ReadsEdgesOverAnyNumberOfPoints) {
  const GraphFile file = parse_graph(
      "VERTEX_SE2 0 0 0 0\nVERTEX_XY 1 3 0\nVERTEX_XY 2 0 4\n"
      "EDGE_SE2_LOTSOFXY 0 1 2 || 2 3 0 0 5 1 0 0 0 1 0 0 1 0 1\n",
      "g");
  EXPECT_NEAR(file.graph.chi2(), 1, 1e-15);
}

TEST(GraphReader, SkipsAndCountsBadLinesIfItIsLenient) {
  ReadOptions lenient;
  lenient.lenient = true;
  const GraphFile file =
      parse_graph(std::string(kTwoPoses) + "VERTEX_SE2 2 x 0 0\nEDGE_SE2 0 1 1\nFIX 0\n", "g", lenient);
  EXPECT_EQ(file.skipped, 2);
  EXPECT_EQ(file.graph.vertex_count(), 2u);
  ASSERT_THAT(file.notes, SizeIs(2));
  EXPECT_TRUE(file.notes[0].skipped);
  EXPECT_EQ(file.notes[0].line, 3);
  EXPECT_EQ(file.notes[0].column, 14);
  EXPECT_EQ(file.notes[0].text, "expected x (a finite number), got 'x'");
}

}  // namespace
}  // namespace boxplus
