// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/structure.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "boxplus/io/graph_file.h"
#include "boxplus/manifold/se2.h"
#include "boxplus/testing/simulate_bundle.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

Graph parsed(const char* text) {
  return parse_graph(text, "test").graph;
}

constexpr const char* kLoop =
    "VERTEX_XY 9 5 6\n"
    "VERTEX_SE2 0 0 0 0\n"
    "VERTEX_SE2 1 1 0 0\n"
    "VERTEX_SE2 2 2 0 0\n"
    "FIX 1\n"
    "EDGE_SE2 0 1 1 0 0 1 0 0 1 0 1\n"
    "EDGE_SE2 0 2 2 0 0 1 0 0 1 0 1\n"
    "EDGE_SE2_XY 2 9 3 6 1 0 1\n"
    "EDGE_SE2 1 2 1 0 0 1 0 0 1 0 1\n";

TEST(Structure, NumbersPosesBeforePoints) {
  const Structure structure = make_structure(parsed(kLoop));
  ASSERT_THAT(structure.vertices, SizeIs(2));
  EXPECT_EQ(structure.vertices[0].shape, Shape::kPose);
  EXPECT_EQ(structure.vertices[1].shape, Shape::kPoint);
  EXPECT_EQ(structure.vertices[1].first, 3U);
  EXPECT_EQ(structure.count, 4U);
  EXPECT_EQ(structure.oriented, 3U);
  EXPECT_EQ(structure.dimension, 2);
  EXPECT_THAT(structure.fixed, ElementsAre(0, 1, 0, 0));
}

TEST(Structure, GroupsLinesByTypeAndRole) {
  const Structure structure = make_structure(parsed(kLoop));
  ASSERT_THAT(structure.line_groups, SizeIs(3));
  EXPECT_EQ(structure.line_groups[0].role, EdgeRole::kOdometry);
  EXPECT_EQ(structure.line_groups[1].role, EdgeRole::kLoopClosure);
  EXPECT_EQ(structure.line_groups[2].role, EdgeRole::kObservation);
  EXPECT_THAT(structure.lines, ElementsAre(0, 1, 1, 2, 0, 2, 2, 3));
  EXPECT_EQ(structure.line_groups[1].first, 2U);
  EXPECT_EQ(structure.line_groups[2].count, 1U);
}

TEST(Structure, CanLeaveOutWhatTakesNoPart) {
  Graph graph = parsed(kLoop);
  for (const EdgeRef& edge : graph.all_edges()) graph.set_level(edge, 1);
  graph.add_vertex(SE2(5, 5, 0));  // it has no edges
  EXPECT_EQ(make_structure(graph, Drawn::kTakingPart).count, 1U);
  graph.set_level(graph.all_edges()[0], 0);
  const Structure structure = make_structure(graph, Drawn::kTakingPart);
  EXPECT_EQ(structure.count, 3U);
  EXPECT_THAT(structure.lines, ElementsAre(0, 1));
  EXPECT_EQ(make_structure(graph).count, 5U);
}

TEST(Structure, HasNoLinesForParametersAndPriors) {
  const Graph graph = parsed(
      "PARAMS_SE3OFFSET 0 0 0 0 0 0 0 1\n"
      "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
      "EDGE_SE3_PRIOR 0 0 0 0 0 0 0 0 1 1 0 0 0 0 0 1 0 0 0 0 1 0 0 0 1 0 0 1 0 1\n");
  const Structure structure = make_structure(graph);
  EXPECT_EQ(structure.count, 1U);
  EXPECT_EQ(structure.dimension, 3);
  EXPECT_THAT(structure.lines, SizeIs(0));
}

TEST(Structure, OfBundleAdjustmentCountsTheObservationsOfEachPoint) {
  BundleOptions options;
  options.cameras = 8;
  options.points = 40;
  const BundleSimulation scene = simulate_bundle(BundleShape::kRing, options);
  const Structure structure = make_structure(scene.graph);
  EXPECT_TRUE(structure.is_bundle);
  ASSERT_THAT(structure.track_lengths, SizeIs(structure.count - structure.oriented));
  std::size_t sum = 0;
  for (const std::uint32_t length : structure.track_lengths) sum += length;
  EXPECT_EQ(sum, scene.graph.edge_count());
}

}  // namespace
}  // namespace boxplus::viewer
