// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void unevaluated_expression(boxplus::Graph& graph) {
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  graph.add_edge([](const auto& x) { return 2.0 * x; }, a);
}
