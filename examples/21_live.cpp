// SPDX-License-Identifier: BSD-3-Clause
// Optimizes while the robot drives: a window of the newest poses after every step, and the whole graph less
// often.
#include <boxplus/boxplus.h>

#include <algorithm>
#include <cstdio>
#include <vector>

using namespace boxplus;

// [window]
/// Moves only the newest `size` poses. All other poses keep their estimates.
Report optimize_window(Graph& graph, const std::vector<VertexHandle<SE2>>& poses, std::size_t size) {
  Options options;
  const std::size_t first = poses.size() - std::min(size, poses.size());
  options.vertices.assign(poses.begin() + static_cast<std::ptrdiff_t>(first), poses.end());
  options.max_iterations = 2;
  return optimize(graph, options);
}
// [/window]

// [whole]
/// Options for an Optimizer that moves all poses. The Optimizer keeps its plan between calls of run(), and
/// adds new vertices and edges to the plan.
Options options_for_steps() {
  Options options;
  options.max_iterations = 1;    // the next run() continues from this result
  options.time_limit_s = 0.010;  // but one step at least; the report says if the limit was reached
  return options;
}
// [/whole]

int main() {
  const SE2 measured(1.02, 0.01, kPi / 2 + 0.03);  // one side of a square, always with the same small error
  Graph graph;
  std::vector<VertexHandle<SE2>> poses{graph.add_vertex(SE2(0, 0, 0))};
  graph.fix(poses[0]);
  std::uint32_t in_window = 0;
  for (int step = 1; step <= 40; ++step) {
    // [step]
    const auto last = poses.back();
    poses.push_back(graph.add_vertex(graph.estimate(last) * measured));
    graph.add_edge(Between(measured), 100.0, last, poses.back());
    in_window = optimize_window(graph, poses, 10).vertices;
    // [/step]
  }
  Optimizer whole(graph, options_for_steps());
  const Report first = whole.run();

  // After four sides, the robot is back at its start. The loop closures below affect more poses than the
  // window contains.
  int extended = 0;
  for (std::size_t k = 4; k < 40; k += 4) {
    graph.add_edge(Between(SE2(0, 0, 0)), 100.0, poses[k - 4], poses[k]);
    const auto last = poses.back();
    poses.push_back(graph.add_vertex(graph.estimate(last) * measured));
    graph.add_edge(Between(measured), 100.0, last, poses.back());
    extended += whole.run().plan_extended ? 1 : 0;
  }
  const Report report = optimize(graph);
  std::printf("a window has %u of %zu poses; the plan was extended %d times; chi2 %.4f\n", in_window,
              poses.size(), extended, report.chi2_final);
  return report.converged() && in_window == 10 && first.iterations <= 1 ? 0 : 1;
}
