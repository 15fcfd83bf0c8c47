// SPDX-License-Identifier: BSD-3-Clause
// Bundle adjustment from a file: `23_bundle_file problem-49-7776-pre.txt` optimizes a problem of "Bundle
// adjustment in the large" and writes it to optimized.bal. Without an argument, the program makes a small
// problem.
#include <boxplus/boxplus.h>
#include <boxplus/robust/huber.h>
#include <boxplus/types/ba.h>

#include <cmath>
#include <cstdio>

using namespace boxplus;

/// Four cameras that look along −z at thirty points. The poses are off by some centimeters.
GraphFile small_problem() {
  GraphFile file;
  file.format = "BAL";
  const BalCamera intrinsics(500, -0.1, 0.02);
  for (int i = 0; i < 4; ++i)
    file.graph.add_vertex(Product(SE3(Vector3(i + 0.05 * (i % 2), 0.04 * i, 0), SO3()), intrinsics));
  for (int k = 0; k < 30; ++k) {
    const auto point =
        file.graph.add_vertex(Vector3(3 * std::sin(k), 3 * std::sin(2.1 * k), std::sin(3.7 * k) - 8));
    for (int i = 0; i < 4; ++i) {
      const Vector2 pixel = intrinsics.project(file.graph.estimate(point) - Vector3(i, 0, 0));
      file.graph.add_edge(Reprojection<BalCamera>(pixel), file.graph.vertex<Product<SE3, BalCamera>>(i),
                          point);
    }
  }
  return parse_graph(format_graph(file), "small problem");
}

int main(int argc, char** argv) {
  // [bundle]
  GraphFile file = argc > 1 ? read_graph(argv[1]) : small_problem();
  for (const EdgeRef& edge : file.edges) file.graph.set_kernel(edge, Huber(2.0));  // pixels
  const Report report = optimize(file.graph);
  const double cost = report.chi2_final / 2;  // as other programs count it
  if (argc > 1) write_graph("optimized.bal", file);
  // [/bundle]
  std::printf("%u of %u vertices eliminated; cost per observation: %.4f\n", report.eliminated,
              report.vertices, cost / static_cast<double>(file.edges.size()));
  return report.converged() && (argc > 1 || cost < 1e-9) ? 0 : 1;
}
