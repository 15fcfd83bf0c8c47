// SPDX-License-Identifier: BSD-3-Clause
#include <boxplus/boxplus.h>
#include <boxplus/viewer/viewer.h>

int main() {
  boxplus::Graph graph;
  const auto x = graph.add_vertex(1.0);
  graph.add_edge([](double value) { return value - 3; }, x);
  boxplus::Viewer viewer(graph);
  return optimize(graph, viewer.watch()).converged() && !viewer.url().empty() ? 0 : 1;
}
