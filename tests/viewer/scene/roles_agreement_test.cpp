// SPDX-License-Identifier: BSD-3-Clause
// The roles of edges are the same in every picture, file and search: odometry is an edge between poses that
// are neighbors in the order of ids, whatever the ids are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>

#include "boxplus/io/graph_file.h"
#include "boxplus/testing/simulate.h"
#include "boxplus/types/slam2d.h"
#include "graph/graph_view.h"
#include "outliers/pose_graph.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {
namespace {

using Counts = std::array<std::size_t, 3>;  // odometry, loop closures, all others with two drawn vertices

/// The lines of a viewer.
Counts drawn(const Graph& graph) {
  Counts counts{};
  for (const LineGroup& group : make_structure(graph).line_groups)
    counts[std::min<std::size_t>(static_cast<std::size_t>(group.role), 2)] += group.count;
  return counts;
}

/// The segments of a .gnuplot file. Each has two lines and a blank one.
Counts written(const Graph& graph) {
  const std::string text = format_graph(graph, {.format = "gnuplot"});
  Counts counts{};
  std::size_t k = 0;
  for (const char* name : {"\n# odometry\n", "\n# closures\n", "\n# observations\n"}) {
    if (const std::size_t begin = text.find(name); begin != std::string::npos) {
      const std::size_t end = std::min(text.find("\n\n\n\n", begin), text.size());
      for (std::size_t at = begin; (at = text.find("\n\n", at + 1)) < end;) ++counts[k];
      counts[k] += end < text.size();  // the blank line before the next data set
    }
    ++k;
  }
  return counts;
}

void expect_agreement(const Graph& graph) {
  const EdgeRoles role(graph);
  std::map<EdgeRole, std::size_t> counts;
  for (const EdgeRef& edge : graph.all_edges()) ++counts[role(edge)];
  EXPECT_EQ(drawn(graph), written(graph));
  EXPECT_EQ(drawn(graph)[0], counts[EdgeRole::kOdometry]);
  EXPECT_EQ(drawn(graph)[1], counts[EdgeRole::kLoopClosure]);
  const outliers::PoseGraph poses(graph, {});
  for (const outliers::PoseEdge& link : poses.links) EXPECT_EQ(role(link.edge), EdgeRole::kOdometry);
  for (const outliers::PoseEdge& closure : poses.closures)
    EXPECT_EQ(role(closure.edge), EdgeRole::kLoopClosure);
  EXPECT_EQ(poses.links.size() + poses.closures.size(),
            counts[EdgeRole::kOdometry] + counts[EdgeRole::kLoopClosure]);
}

TEST(RolesOfEdges, AgreeInEverySimulatedWorld) {
  for (const World world : kWorlds) {
    SCOPED_TRACE(to_string(world));
    expect_agreement(simulate(world, {.poses = 300}).graph);
  }
}

TEST(RolesOfEdges, AgreeIfIdsHaveGaps) {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (const Id id : {0, 10, 20}) poses.push_back(graph.add_vertex(SE2(static_cast<double>(id), 0, 0), id));
  graph.add_edge(Between(SE2(10, 0, 0)), poses[0], poses[1]);
  graph.add_edge(Between(SE2(10, 0, 0)), poses[1], poses[2]);
  graph.add_edge(Between(SE2(20, 0, 0)), poses[0], poses[2]);
  expect_agreement(graph);
  EXPECT_EQ(drawn(graph), (Counts{2, 1, 0}));
}

}  // namespace
}  // namespace boxplus::viewer
