// SPDX-License-Identifier: BSD-3-Clause
// A robot drives along a square and returns to its start. README.md shows this program.

// [program]
#include <boxplus/boxplus.h>

#include <iostream>
using namespace boxplus;
int main() {
  Graph graph;
  auto a = graph.add_vertex(SE2(0, 0, 0));  // poses: x, y in meters, heading in radians
  auto b = graph.add_vertex(SE2(0.9, 0.1, 1.4));
  auto c = graph.add_vertex(SE2(1.2, 1.1, 3.0));
  graph.fix(a);
  const double information = 100;                                  // or an Eigen matrix
  graph.add_edge(Between(SE2(1, 0, kPi / 2)), information, a, b);  // ready-made edge: b relative to a
  graph.add_edge(Between(SE2(1, 0, kPi / 2)), information, b, c);
  graph.add_edge([](const auto& p) { return p.y() - 1.02; }, information, c);  // any callable can be an edge
  Report report = optimize(graph);
  std::cout << report << graph.estimate(c).vector().transpose() << "\n";
  return report.converged() ? 0 : 1;
}
// [/program]
