// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Temperature {
  double measurement;
  double residual(double x) const { return x - measurement; }
};

void no_error_function(boxplus::Graph& graph) {
  graph.add_edge(Temperature{300}, graph.add_vertex(0.0));
}
