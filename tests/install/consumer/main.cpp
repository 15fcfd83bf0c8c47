// SPDX-License-Identifier: BSD-3-Clause
// A minimal program that optimizes a graph with the installed library.
#include <boxplus/boxplus.h>

static_assert(EIGEN_MAX_ALIGN_BYTES == 16,
              "the target boxplus::boxplus must pass this definition on to its clients");

int main() {
  using namespace boxplus;
  Graph graph;
  const auto a = graph.add_vertex(SE2(0, 0, 0));
  const auto b = graph.add_vertex(SE2(0.9, 0.1, 0));
  graph.fix(a);
  graph.add_edge(Between(SE2(1, 0, 0)), 100.0, a, b);
  graph.add_edge([](const auto& x) { return x.theta() - 0.1; }, b);
  const Report report = optimize(graph);
  return report.converged() && graph.estimate(b).x() > 0.99 ? 0 : 1;
}
