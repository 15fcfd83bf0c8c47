// SPDX-License-Identifier: BSD-3-Clause
#include "growing/graph_feed.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/registry.h"
#include "boxplus/robust/huber.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"

namespace boxplus::programs {
namespace {

TEST(GraphFeed, AStepAddsTheEdgesOfOnePoseAndTheirLandmarks) {
  // Landmarks have larger ids than poses.
  const GraphFile file = parse_graph(
      "VERTEX_SE2 0 1 0 0\nVERTEX_SE2 1 9 9 9\nVERTEX_SE2 2 9 9 9\nVERTEX_XY 100 9 9\nVERTEX_XY 200 3 4\n"
      "EDGE_SE2_XY 1 100 1 1 1 0 1\nEDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\nEDGE_SE2 0 1 2 0 0 1 0 0 1 0 1\n",
      "file");
  Graph graph;
  GraphFeed feed(file.graph, file.edges, graph);
  ASSERT_TRUE(feed.step());
  EXPECT_EQ(graph.vertex_count(), 3u);  // 0, 1 and 100
  EXPECT_EQ(graph.estimate(graph.vertex<SE2>(1)).vector(), Vector3(3, 0, 0));
  EXPECT_EQ(graph.estimate(graph.vertex<Vector2>(100)), Vector2(4, 1));
  ASSERT_TRUE(feed.step());
  EXPECT_EQ(graph.edge_count(), 3u);
  EXPECT_FALSE(feed.step());
  EXPECT_EQ(graph.estimate(graph.vertex<Vector2>(200)), Vector2(3, 4));  // no edge uses it
}

TEST(GraphFeed, TheGrownGraphIsTheGraphOfTheFile) {
  for (const World world : {World::kManhattan, World::kCity, World::kPlanes, World::kLines, World::kSphere}) {
    const Simulation simulation = simulate(world, {.poses = 60});
    Graph graph, copy = simulation.graph;
    GraphFeed feed(simulation.graph, simulation.edges, graph);
    while (feed.step()) {
    }
    EXPECT_EQ(graph.vertex_count(), copy.vertex_count()) << to_string(world);
    feed.copy_estimates_to(copy);
    EXPECT_NEAR(copy.chi2(), graph.chi2(), 1e-9 * graph.chi2()) << to_string(world);
    for (const VertexRef& vertex : copy.all_vertices())
      EXPECT_EQ(graph.is_fixed(*graph.find_vertex(copy.id(vertex))), copy.is_fixed(vertex))
          << to_string(world);
  }
}

TEST(GraphFeed, AttributesOfElementsAreKept) {
  GraphFile file = parse_graph(
      "VERTEX_SE2 0 0 0 0\nFIX 0\nVERTEX_SE2 1 1 0 0\nEDGE_SE2 0 1 5 0 0 1 0 0 1 0 1\nEDGE_SE2 0 1 1 0 0 1 0 "
      "0 1 0 1\n"
      "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n",
      "file");
  file.graph.set_kernel(file.edges[0], Huber(0.5));
  file.graph.set_enabled(file.edges[1], false);
  file.graph.set_level(file.edges[2], 2);
  file.graph.fix_directions(*file.graph.find_vertex(1), {2});
  Graph graph;
  GraphFeed feed(file.graph, file.edges, graph);
  while (feed.step()) {
  }
  const std::vector<EdgeRef> edges = graph.all_edges();
  EXPECT_NE(graph.kernel(edges[0]), nullptr);
  EXPECT_FALSE(graph.is_enabled(edges[1]));
  EXPECT_EQ(graph.level(edges[2]), 2);
  EXPECT_THAT(graph.fixed_directions(*graph.find_vertex(1)), testing::ElementsAre(2));
}

TEST(GraphFeed, ATypeWithoutATagIsRefused) {
  Graph source, graph;
  const auto a = source.add_vertex(Vector<double, 5>(Vector<double, 5>::Zero()));
  const auto edge = source.add_edge([](const Vector<double, 5>& x) { return Vector2(x[0], x[1]); }, a);
  GraphFeed feed(source, {edge}, graph);
  EXPECT_THROW(feed.step(), InvalidArgument);
}

}  // namespace
}  // namespace boxplus::programs
