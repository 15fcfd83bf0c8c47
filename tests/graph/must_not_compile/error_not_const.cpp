// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Temperature {
  double measurement;
  double error(double x) { return x - measurement; }
};

void error_not_const(boxplus::Graph& graph) {
  graph.add_edge(Temperature{300}, graph.add_vertex(0.0));
}
