// SPDX-License-Identifier: BSD-3-Clause
// A graph that grows while the robot drives. Each loop closure is tested before it is accepted.
#include <boxplus/boxplus.h>

#include <cstdio>
#include <vector>

using namespace boxplus;

// [try_edge]
/// Adds the edge if it agrees with the graph. Otherwise leaves the graph as it was.
bool try_edge(Graph& graph, const SE2& measured, VertexHandle<SE2> a, VertexHandle<SE2> b) {
  const double believable = 12.8;  // the chi2 of 3 rows is larger in only one of 200 cases
  const double before = graph.chi2();
  graph.push();  // saves all estimates
  const auto edge = graph.add_edge(Between(measured), 100.0, a, b);
  const Report report = optimize(graph);
  if (report.converged() && report.chi2_final - before < believable) {
    graph.discard_top();  // drops the saved estimates
    return true;
  }
  graph.remove(edge);
  graph.pop();  // restores the estimates
  return false;
}
// [/try_edge]

int main() {
  const SE2 measured(1.02, 0.01, kPi / 2 + 0.03);  // a side of a square, with the same small error each time

  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2(0, 0, 0))};
  graph.fix(poses[0]);
  for (int step = 0; step < 8; ++step) {
    const auto last = poses.back();
    poses.push_back(graph.add_vertex(graph.estimate(last) * measured));
    graph.add_edge(Between(measured), 100.0, last, poses.back());
    if (!optimize(graph).converged()) return 1;
  }

  // After four sides the robot is back at its start, and recognizes the place.
  const bool good = try_edge(graph, SE2(0, 0, 0), poses[0], poses[4]);
  // A false closure: the robot mistakes one corner for the opposite corner.
  const SE2 kept = graph.estimate(poses[8]);
  const bool bad = try_edge(graph, SE2(0, 0, 0), poses[0], poses[6]);
  std::printf("true closure %s, false closure %s\n", good ? "accepted" : "refused",
              bad ? "accepted" : "refused");
  const bool is_restored = graph.estimate(poses[8]).vector() == kept.vector();

  // [subset]
  // Only the last three poses move. Edges that connect none of these poses are left out.
  Options options;
  options.vertices = {poses[6], poses[7], poses[8]};
  const Report local = optimize(graph, options);
  // [/subset]
  std::printf("local optimization: %u vertices, %u edges\n", local.vertices, local.edges);
  return good && !bad && is_restored && local.converged() && local.vertices == 3 ? 0 : 1;
}
