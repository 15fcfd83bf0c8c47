// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void wrong_estimates(boxplus::Graph& graph) {
  const auto a = graph.add_vertex(Eigen::Vector2d(1, 2));
  graph.add_edge([](double x) { return x; }, a);
}
