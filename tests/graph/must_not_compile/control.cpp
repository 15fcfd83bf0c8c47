// SPDX-License-Identifier: BSD-3-Clause
// The counterpart of the other files in this folder: all of it is right, and compiles.
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void control(boxplus::Graph& graph) {
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  const std::vector<boxplus::VertexHandle<double>> rest{graph.add_vertex(1.0)};
  graph.add_edge([](const auto& x) { return (2.0 * x).eval(); }, a);
  graph.add_edge([](const auto& x, const auto& tail) { return x[0] - tail[0]; }, a, rest);
}
