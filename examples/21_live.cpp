// SPDX-License-Identifier: BSD-3-Clause
// Optimizes while the robot drives: only a window of the newest poses, or the whole graph with a Smoother.
#include <boxplus/boxplus.h>
#include <boxplus/incremental/smoother.h>

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
/// Options for a Smoother, which moves all poses. It computes anew only what a change of the graph affects.
SmootherOptions options_for_steps() {
  SmootherOptions options;
  options.time_limit_s = 0.010;  // but one iteration at least; the next update() continues
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
  Smoother smoother(graph, options_for_steps());
  smoother.update();

  // After four sides, the robot is back at its start. The loop closures below affect more poses than the
  // window contains.
  int updates = 0;
  for (std::size_t k = 4; k < 40; k += 4) {
    graph.add_edge(Between(SE2(0, 0, 0)), 100.0, poses[k - 4], poses[k]);
    const auto last = poses.back();
    poses.push_back(graph.add_vertex(graph.estimate(last) * measured));
    graph.add_edge(Between(measured), 100.0, last, poses.back());
    if (smoother.update().iterations > 0) ++updates;
  }
  const double chi2_of_smoother = graph.chi2();
  const Report report = optimize(graph);
  std::printf("a window has %u of %zu poses; after %d updates, chi2 is %.4f; the optimum is %.4f\n",
              in_window, poses.size(), updates, chi2_of_smoother, report.chi2_final);
  return report.converged() && in_window == 10 && updates == 9 ? 0 : 1;
}
