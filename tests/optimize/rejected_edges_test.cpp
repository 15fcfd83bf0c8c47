// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/rejected_edges.h"

#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

/// Errors of 0, 1, 10 and 1000 standard deviations, again and again.
std::vector<EdgeRef> add_errors(Graph& graph, int count) {
  const auto x = graph.add_vertex(0.0);
  std::vector<EdgeRef> edges;
  for (int k = 0; k < count; ++k) {
    const double value = std::vector{0.0, 1.0, 10.0, 1000.0}[static_cast<std::size_t>(k % 4)];
    edges.push_back(graph.add_edge(Prior(value), x));
  }
  return edges;
}

TEST(RejectedEdges, AreTheEdgesWhoseKernelGivesThemAWeightBelowTheLimit) {
  Graph graph;
  const std::vector<EdgeRef> edges = add_errors(graph, 400);  // more than one tile
  graph.add_edge(Between(1.0), graph.add_vertex(0.0), graph.add_vertex(0.0));
  for (const EdgeRef& edge : edges) graph.set_kernel(edge, Tukey(5));
  graph.set_kernel(edges[3], nullptr);
  graph.set_kernel(edges[6], Huber(5));     // weight 1/2
  graph.set_kernel(edges[7], Huber(0.5));   // weight 0.0005
  graph.set_kernel(edges[11], Cauchy(40));  // weight 0.0016
  graph.set_enabled(edges[15], false);
  const Plan plan = make_plan(graph, {});
  std::uint32_t expected = 0;
  for (const EdgeRef& edge : edges) expected += graph.is_enabled(edge) && graph.weight(edge) < 1e-3;
  for (const int workers : {1, 3}) {
    const RejectionCounts counts = count_rejected(graph, plan, workers);
    EXPECT_EQ(counts.rejected, expected);
    EXPECT_EQ(counts.rejected, 200u - 4);  // all errors of 10 and 1000, except for edges 3, 6, 11, 15
    EXPECT_EQ(counts.redescending, 400u - 4);
    EXPECT_EQ(counts.by_redescending, expected - 1);
  }
}

TEST(RejectedEdges, AreFlaggedIfARedescendingKernelRejectsThem) {
  Graph graph;
  const std::vector<EdgeRef> edges = add_errors(graph, 200);
  for (const EdgeRef& edge : edges) graph.set_kernel(edge, Saturated(2));
  graph.set_kernel(edges[7], Huber(0.5));
  const std::vector<std::uint8_t> flags = flag_rejected(graph, make_plan(graph, {}));
  ASSERT_EQ(flags.size(), 200u);
  for (std::size_t k = 0; k < flags.size(); ++k) EXPECT_EQ(flags[k] != 0, k % 4 >= 2 && k != 7) << k;
}

}  // namespace
}  // namespace boxplus
