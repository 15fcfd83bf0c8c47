// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void mutable_lambda(boxplus::Graph& graph) {
  int calls = 0;
  graph.add_edge([calls](double x) mutable { return x - ++calls; }, graph.add_vertex(0.0));
}
