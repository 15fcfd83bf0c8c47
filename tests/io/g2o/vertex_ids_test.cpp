// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/vertex_ids.h"

#include <gmock/gmock.h>

#include "boxplus/io/graph_file.h"

namespace boxplus {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST(VertexIds, CreateTheOtherVertexOfAnEdgeWithAnUnassignedVertex) {
  const GraphFile file = parse_graph(
      "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 -1 0 1 0 0 1 0 0 1 0 1\n",
      "edges");
  EXPECT_TRUE(file.graph.find_vertex(0));
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  const std::string written = format_graph(file);
  EXPECT_EQ(format_graph(parse_graph(written, "written")), written);
}

TEST(VertexIds, CreateTheVerticesOfAFileWithEdgesOnly) {
  const GraphFile file = parse_graph("EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2_XY 1 9 1 0 1 0 1\n", "g");
  EXPECT_TRUE(file.vertices_created);
  EXPECT_EQ(file.graph.vertex_count(), 3u);
  ASSERT_THAT(file.notes, SizeIs(1));
  EXPECT_THAT(file.notes[0].text, HasSubstr("3 vertices were created"));
}

TEST(VertexIds, KeepALineButAddNoEdgeIfAVertexIsUnassigned) {
  const GraphFile file = parse_graph("VERTEX_SE2 0 0 0 0\nEDGE_SE2 0 -1 1 0 0 1 0 0 1 0 1\n", "g");
  EXPECT_THAT(file.edges, IsEmpty());
  EXPECT_THAT(file.kept, SizeIs(1));
}

TEST(VertexIds, CreateNoVerticesForSkippedLines) {
  const GraphFile file = parse_graph(
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\nEDGE_SE2 1 7 1 0 0 1 0 0 1 0 x\nEDGE_SE2 9 9 1 0 0 1 0 0 1 0 1\n"
      "EDGE_SE2 1 8 1 0 0 1 2 0 1 0 1\n",
      "g", {.lenient = true});
  EXPECT_EQ(file.skipped, 3);
  EXPECT_EQ(file.graph.vertex_count(), 2u);
}

}  // namespace
}  // namespace boxplus
