// SPDX-License-Identifier: BSD-3-Clause
#include "linear/ordering/vertex_separator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "linear/test_system.h"

namespace boxplus {
namespace {

TEST(VertexSeparator, DividesAWideGridIntoHalvesByAboutOneColumn) {
  const std::uint32_t height = 30, width = 50;
  WeightedGraph graph;
  std::vector<std::vector<std::uint32_t>> neighbors(height * width);
  for (const auto& [a, b] : grid_edges(height, width)) neighbors[a].push_back(b), neighbors[b].push_back(a);
  for (const auto& list : neighbors) {
    graph.neighbor.insert(graph.neighbor.end(), list.begin(), list.end());
    graph.start.push_back(static_cast<std::uint32_t>(graph.neighbor.size()));
    graph.weight.push_back(3);
  }
  graph.edge_weight.assign(graph.neighbor.size(), 1);
  const std::vector<Side> side = find_separator(graph);
  for (std::uint32_t v = 0; v < graph.vertices(); ++v) {
    for (const std::uint32_t u : graph.neighbors(v))
      EXPECT_FALSE(side[v] == kLeft && side[u] == kRight) << v << " touches " << u;
  }
  const auto count = [&](Side wanted) { return std::count(side.begin(), side.end(), wanted); };
  EXPECT_LE(count(kSeparator), 40);
  EXPECT_LE(std::max(count(kLeft), count(kRight)), 900);
}

}  // namespace
}  // namespace boxplus
