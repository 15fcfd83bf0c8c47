// SPDX-License-Identifier: BSD-3-Clause
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void range_before_handle(boxplus::Graph& graph) {
  const std::vector<boxplus::VertexHandle<double>> first{graph.add_vertex(1.0)};
  graph.add_edge([](std::span<const double> x, double y) { return x[0] - y; }, first, graph.add_vertex(1.0));
}
