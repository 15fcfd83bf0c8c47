// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Square {
  template <class S>
  S error(const S& x) const {
    return x * x;
  }
  void jacobians(double x, Eigen::Ref<boxplus::Matrix<double, 1, 1>> J) { J(0, 0) = 2 * x; }
};

void jacobians_not_const(boxplus::Graph& graph) {
  graph.add_edge(Square{}, graph.add_vertex(1.0));
}
