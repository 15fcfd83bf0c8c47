// SPDX-License-Identifier: BSD-3-Clause
// Why did it fail? diagnose() says what is wrong with a graph, and how to mend it.
#include <boxplus/boxplus.h>
#include <boxplus/diagnose/diagnose.h>
#include <boxplus/types/slam2d.h>

#include <iostream>
#include <vector>

using namespace boxplus;

int main() {
  Graph graph;
  std::vector<VertexHandle<SE2>> poses;
  for (int i = 0; i < 5; ++i) poses.push_back(graph.add_vertex(SE2(i, 0, 0)));
  for (std::size_t i = 1; i < poses.size(); ++i)
    graph.add_edge(Between(SE2(1, 0, 0)), 100.0, poses[i - 1], poses[i]);
  graph.fix(poses[0]);
  const auto landmark = graph.add_vertex(Vector2(2, 3));
  graph.add_edge(BearingObservation2(0.98), poses[0], landmark);  // one bearing does not say how far it is

  // [diagnose]
  const Diagnosis diagnosis = diagnose(graph);
  std::cout << diagnosis;
  for (const Finding& finding : diagnosis.findings) {
    if (finding.kind != Finding::Kind::kSeenOnce) continue;
    for (const VertexRef& point : finding.vertices) graph.remove(point);
  }
  // [/diagnose]
  return !diagnosis.ok() && diagnose(graph).ok() ? 0 : 1;
}
