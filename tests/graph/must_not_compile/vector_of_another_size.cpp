// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Height {
  template <class S>
  S error(const boxplus::Vector<S, 3>& point) const {
    return point[2];
  }
};

void vector_of_another_size(boxplus::Graph& graph) {
  graph.add_edge(Height{}, graph.add_vertex(boxplus::Vector2(1, 2)));
}
