// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Square {
  template <class S>
  S error(const S& x) const {
    return x * x;
  }
  void jacobian(double x, Eigen::Ref<boxplus::Matrix<double, 1, 1>> J) const { J(0, 0) = 2 * x; }
};

void jacobian_instead_of_jacobians(boxplus::Graph& graph) {
  graph.add_edge(Square{}, graph.add_vertex(1.0));
}
