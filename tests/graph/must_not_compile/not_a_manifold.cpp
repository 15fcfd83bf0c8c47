// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"

struct Temperature {
  double kelvin;
};

void not_a_manifold(boxplus::Graph& graph) {
  graph.add_vertex(Temperature{300});
}
