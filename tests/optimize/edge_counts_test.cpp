// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/edge_counts.h"

#include <gtest/gtest.h>

#include "optimize/small_graphs.h"

namespace boxplus {
namespace {

TEST(EdgeCounts, CountRowsAndKernelsOfEnabledActiveEdges) {
  Graph graph;
  const auto poses = add_noisy_circle(graph, 5);
  const auto last = graph.add_vertex(Eigen::VectorXd(Eigen::VectorXd::Zero(4)));
  graph.add_edge(Prior(Eigen::VectorXd(Eigen::VectorXd::Ones(4))), last);
  const std::vector<EdgeRef> edges = graph.all_edges();
  graph.set_enabled(edges[0], false);
  graph.set_kernel(edges[0], Huber(1.0));
  graph.set_kernel(edges[1], Huber(1.0));
  graph.set_level(edges[2], 1);
  const EdgeCounts counts = EdgeCounter().count(graph, make_plan(graph, {}));
  EXPECT_EQ(counts.rows, 3 * 3 + 4u);
  EXPECT_EQ(counts.disabled, 1u);
  EXPECT_EQ(counts.robust, 1u);
}

}  // namespace
}  // namespace boxplus
