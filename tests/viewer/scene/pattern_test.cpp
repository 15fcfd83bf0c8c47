// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace boxplus::viewer {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

/// A fixed vertex that all others see, and edges between the others.
Graph graph_of(int vertices, const std::vector<std::pair<int, int>>& edges) {
  std::string text = "VERTEX_SE2 1000000 0 0 0\nFIX 1000000\n";
  const auto add_edge = [&](int a, int b) {
    text += "EDGE_SE2 " + std::to_string(a) + " " + std::to_string(b) + " 0 0 0 1 0 0 1 0 1\n";
  };
  for (int id = 0; id < vertices; ++id) text += "VERTEX_SE2 " + std::to_string(id) + " 0 0 0\n";
  for (int id = 0; id < vertices; ++id) add_edge(1000000, id);
  for (const auto& [a, b] : edges) add_edge(a, b);
  return parse_graph(text, "test.g2o").graph;
}

TEST(Pattern, OfAStarWhoseCenterComesFirstIsDenseByIdAndSparseInOrder) {
  const Pattern pattern = read_pattern(graph_of(4, {{0, 1}, {0, 2}, {0, 3}}));
  EXPECT_EQ(pattern.size, 4U);
  EXPECT_EQ(pattern.cells, 4U);
  EXPECT_THAT(pattern.H_by_id.counts, ElementsAre(1, 0, 0, 0,  //
                                                  1, 1, 0, 0,  //
                                                  1, 0, 1, 0,  //
                                                  1, 0, 0, 1));
  EXPECT_THAT(pattern.L_by_id.counts, ElementsAre(1, 0, 0, 0,  //
                                                  1, 1, 0, 0,  //
                                                  1, 1, 1, 0,  //
                                                  1, 1, 1, 1));
  EXPECT_EQ(pattern.H_by_id.blocks, 7U);
  EXPECT_EQ(pattern.L_by_id.blocks, 10U);
  EXPECT_EQ(pattern.H_ordered.blocks, 7U);
  EXPECT_EQ(pattern.L_ordered.blocks, 7U);
  EXPECT_EQ(pattern.L_ordered.counts, pattern.H_ordered.counts);
}

TEST(Pattern, OfALoopHasFillInItsLastRow) {
  const Pattern pattern = read_pattern(graph_of(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {0, 4}}));
  EXPECT_THAT(pattern.L_by_id.counts, ElementsAre(1, 0, 0, 0, 0,  //
                                                  1, 1, 0, 0, 0,  //
                                                  0, 1, 1, 0, 0,  //
                                                  0, 0, 1, 1, 0,  //
                                                  1, 1, 1, 1, 1));
  EXPECT_TRUE(pattern.L_by_id.is_complete);
}

TEST(Pattern, OfALargeGraphCountsTheBlocksInEachCell) {
  const std::uint32_t size = 4 * Pattern::kMostCells;
  std::vector<std::pair<int, int>> chain;
  for (int id = 1; id < static_cast<int>(size); ++id) chain.emplace_back(id - 1, id);
  const Pattern pattern = read_pattern(graph_of(static_cast<int>(size), chain));
  EXPECT_EQ(pattern.size, size);
  EXPECT_EQ(pattern.cells, Pattern::kMostCells);
  const std::vector<std::uint32_t>& counts = pattern.H_by_id.counts;
  ASSERT_THAT(counts, SizeIs(std::size_t{Pattern::kMostCells} * Pattern::kMostCells));
  EXPECT_EQ(counts[0], 7U);                    // four blocks of the diagonal, and three below it
  EXPECT_EQ(counts[Pattern::kMostCells], 1U);  // between the last vertex of the first cell and the next one
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0U), 2 * size - 1);
  EXPECT_EQ(pattern.L_ordered.blocks, 2 * size - 1);
}

TEST(Pattern, OfAGraphInWhichNothingMovesIsEmpty) {
  const Pattern pattern = read_pattern(graph_of(0, {}));
  EXPECT_EQ(pattern.cells, 0U);
  EXPECT_EQ(pattern.L_ordered.blocks, 0U);
}

TEST(Pattern, CanBeStopped) {
  const std::atomic<bool> stop = true;
  EXPECT_THROW(read_pattern(graph_of(3, {{0, 1}}), StopToken(&stop)), Stopped);
}

}  // namespace
}  // namespace boxplus::viewer
