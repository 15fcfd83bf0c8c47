// SPDX-License-Identifier: BSD-3-Clause
// Graph::edges(): the edges that use a vertex.
#include "graph/incidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <span>
#include <vector>

#include "boxplus/manifold/rn.h"

namespace boxplus {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto kDifference = [](const auto& x, const auto& y) { return y - x; };
constexpr auto kPrior = [](const auto& x) { return x - 1.0; };
constexpr auto kSum = [](std::span<const double> all) {
  double sum = 0;
  for (const double x : all) sum += x;
  return sum;
};

/// The edges of a vertex, found by a search through all edges.
std::vector<EdgeRef> edges_by_search(const Graph& graph, VertexRef vertex) {
  std::vector<EdgeRef> result;
  for (const EdgeRef& edge : graph.all_edges()) {
    const std::vector<VertexRef> vertices = graph.vertices(edge);
    if (std::find(vertices.begin(), vertices.end(), vertex) != vertices.end()) result.push_back(edge);
  }
  return result;
}

TEST(EdgesOfAVertex, AreListedInTheOrderOfAllEdges) {
  Graph graph;
  const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), lonely = graph.add_vertex(3.0);
  const auto ab = graph.add_edge(kDifference, a, b);
  const auto prior = graph.add_edge(kPrior, b);
  const auto ba = graph.add_edge(kDifference, b, a);
  EXPECT_THAT(graph.edges(a), ElementsAre(EdgeRef(ab), EdgeRef(ba)));
  EXPECT_THAT(graph.edges(b), ElementsAre(EdgeRef(ab), EdgeRef(ba), EdgeRef(prior)));
  EXPECT_THAT(graph.edges(lonely), IsEmpty());
}

TEST(EdgesOfAVertex, IncludeEdgesOfParametersAndEdgesOverRanges) {
  Graph graph;
  const auto offset = graph.add_parameter(0.5);
  const std::vector tail{graph.add_vertex(1.0), graph.add_vertex(2.0), graph.add_vertex(3.0)};
  const auto measured = graph.add_edge(kDifference, offset, tail[0]);
  const auto sum = graph.add_edge(kSum, tail);
  EXPECT_THAT(graph.edges(offset), ElementsAre(EdgeRef(measured)));
  EXPECT_THAT(graph.edges(tail[0]), ElementsAre(EdgeRef(measured), EdgeRef(sum)));
  EXPECT_THAT(graph.edges(tail[2]), ElementsAre(EdgeRef(sum)));
}

TEST(EdgesOfAVertex, CannotBeListedForAStaleHandle) {
  Graph graph;
  const auto a = graph.add_vertex(1.0);
  graph.remove(a);
  EXPECT_THROW((void)graph.edges(a), InvalidArgument);
}

TEST(EdgesOfAVertex, StayCorrectWhileTheGraphChanges) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  };
  Graph graph;
  std::vector<VertexHandle<double>> vertices;
  for (int step = 0; step < 3000; ++step) {
    const std::size_t choice = below(10);
    if (vertices.size() < 4 || choice == 0) {
      vertices.push_back(graph.add_vertex(1.0));
    } else if (choice == 1 && vertices.size() > 20) {
      const std::size_t gone = below(vertices.size());
      graph.remove(vertices[gone]);
      vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(gone));
    } else if (choice < 5 && graph.edge_count() > 0) {
      const auto edges = graph.all_edges();
      graph.remove(edges[below(edges.size())]);
    } else {
      const std::size_t first = below(vertices.size() - 2);
      if (choice < 8) graph.add_edge(kDifference, vertices[first], vertices[first + 1]);
      if (choice >= 8) graph.add_edge(kSum, std::span(vertices).subspan(first, 1 + below(3)));
    }
    const auto& asked = vertices[below(vertices.size())];
    ASSERT_EQ(graph.edges(asked), edges_by_search(graph, asked)) << "step " << step;
  }
}

TEST(EdgesOfAVertex, AreRemovedWithTheirVertexWhetherOrNotTheyWereListed) {
  for (const bool listed : {false, true}) {
    Graph graph;
    const auto a = graph.add_vertex(1.0), b = graph.add_vertex(2.0), c = graph.add_vertex(3.0);
    const auto ab = graph.add_edge(kDifference, a, b), bc = graph.add_edge(kDifference, b, c);
    if (listed) (void)graph.edges(a);
    const auto ca = graph.add_edge(kDifference, c, a);
    graph.remove(a);
    EXPECT_FALSE(graph.contains(ab));
    EXPECT_FALSE(graph.contains(ca));
    EXPECT_THAT(graph.edges(b), ElementsAre(EdgeRef(bc)));
    EXPECT_EQ(graph.edge_count(), 1u);
  }
}

TEST(EdgesOfAVertex, AreListedAgainAfterClear) {
  Graph graph;
  const auto old = graph.add_vertex(1.0);
  graph.add_edge(kPrior, old);
  EXPECT_EQ(graph.edges(old).size(), 1u);
  graph.clear();
  const auto a = graph.add_vertex(1.0);
  EXPECT_THAT(graph.edges(a), IsEmpty());
  const auto edge = graph.add_edge(kPrior, a);
  EXPECT_THAT(graph.edges(a), ElementsAre(EdgeRef(edge)));
}

}  // namespace
}  // namespace boxplus
