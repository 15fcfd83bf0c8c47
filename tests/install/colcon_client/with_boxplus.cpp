// SPDX-License-Identifier: BSD-3-Clause
#include <boxplus/boxplus.h>

using namespace boxplus;

int main() {
  Graph graph;
  const auto a = graph.add_vertex(SE2()), b = graph.add_vertex(SE2());
  graph.fix(a);
  graph.add_edge(Between(SE2(1, 2, 0.5)), 1.0, a, b);
  return optimize(graph).converged() && std::abs(graph.estimate(b).y() - 2) < 1e-9 ? 0 : 1;
}
