// SPDX-License-Identifier: BSD-3-Clause
// Optimizes a graph with many outliers: 30 % of the loop closures are wrong, and the initial estimates come
// from the odometry alone.
//
// While the estimates are bad, a kernel that rejects outliers also rejects correct measurements. So this
// program starts with least squares, and makes the kernel stricter in every iteration. This method is known
// as graduated non-convexity. The program uses Barron's family of kernels, which ranges from squared errors
// (α = 2) to a kernel that almost ignores large errors (α = −10).
#include <boxplus/boxplus.h>
#include <boxplus/robust/barron.h>
#include <boxplus/robust/default_width.h>
#include <boxplus/robust/redescending.h>
#include <boxplus/testing/simulate.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

using namespace boxplus;

/// Returns the mean distance (meters) between the estimated and the true positions of the poses.
double error_of(const Simulation& world) {
  double sum = 0;
  for (const VertexRef& vertex : world.graph.all_vertices()) {
    const Id id = world.graph.id(vertex);
    const SE2& pose = world.graph.estimate(world.graph.typed<SE2>(vertex));
    sum += (pose.translation() - world.truth.estimate(world.truth.vertex<SE2>(id)).translation()).norm();
  }
  return sum / static_cast<double>(world.graph.vertex_count());
}

Simulation make_world() {
  return simulate(World::kStreets, {.poses = 2000, .outliers = 0.3});
}

/// Returns the loop closures. Only loop closures get a kernel, because the odometry has no outliers.
std::vector<EdgeRef> closures_of(const Simulation& world) {
  std::vector<EdgeRef> closures;
  for (std::size_t k = 0; k < world.edges.size(); ++k) {
    if (world.kinds[k] != EdgeKind::kOdometry) closures.push_back(world.edges[k]);
  }
  return closures;
}

double with_fixed_kernel(const RobustKernel* kernel) {
  Simulation world = make_world();
  for (const EdgeRef& edge : closures_of(world)) {
    if (kernel) world.graph.set_kernel(edge, kernel->clone());
  }
  const Report report = optimize(world.graph);
  const bool ended = report.converged() || report.reason == Report::Reason::kRejectedEdges;
  return ended ? error_of(world) : 1e9;
}

double annealed() {
  Simulation world = make_world();
  Graph& graph = world.graph;
  const std::vector<EdgeRef> closures = closures_of(world);

  // [anneal]
  double shape = 2;  // α of Barron's kernel
  const auto anneal = [&](const IterationRecord&) {
    shape = std::max(shape - 0.5, -10.0);
    const auto kernel = std::make_shared<const Barron>(shape, default_width(3));  // for errors with 3 rows
    for (const EdgeRef& edge : closures) graph.set_kernel(edge, kernel);
    return true;
  };
  Options options;
  options.callback = anneal;
  Report report = optimize(graph, options);

  while (shape > -10) anneal({});  // makes the remaining changes if the optimization stopped early
  report = optimize(graph);
  // [/anneal]
  return report.converged() ? error_of(world) : 1e9;
}

int main() {
  const Cauchy cauchy(default_width(3));
  const Barron strict(-10, default_width(3));
  const double odometry = error_of(make_world()), squares = with_fixed_kernel(nullptr);
  const double mild = with_fixed_kernel(&cauchy), rejecting = with_fixed_kernel(&strict), best = annealed();
  std::printf("odometry            %6.2f m\n", odometry);
  std::printf("least squares       %6.2f m\n", squares);
  std::printf("Cauchy              %6.2f m\n", mild);
  std::printf("Barron, α = -10     %6.2f m\n", rejecting);
  std::printf("annealed to α = -10 %6.2f m\n", best);
  return best < 0.25 && best < 0.75 * mild && best < 0.1 * std::min({odometry, squares, rejecting}) ? 0 : 1;
}
