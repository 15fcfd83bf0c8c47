// SPDX-License-Identifier: BSD-3-Clause
// Measures one step of a robot that optimizes while it drives. A step adds a pose and its edges, and then
// runs one iteration. The benchmark compares the CPU time of three kinds of iterations: over all vertices
// with an extended plan, over all vertices with a new plan, and over a window of the last poses. A plan
// contains the elimination order and memory layout of H; docs/live.md describes when it can be extended.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"
#include "boxplus/testing/simulate.h"
#include "datasets/cpu_time.h"
#include "datasets/median.h"

namespace boxplus::bench {
namespace {

/// Builds a copy of a simulated graph, pose by pose.
template <class Pose>
class Drive {
 public:
  explicit Drive(const Simulation& world) : world_(world), all_(world.graph.all_vertices()) {
    std::map<Id, std::size_t> index;
    for (std::size_t k = 0; k < all_.size(); ++k) index[world.graph.id(all_[k])] = k;
    for (const EdgeRef& edge : world.edges) {
      const auto ends = world.graph.vertices(edge);
      const std::size_t a = index[world.graph.id(ends[0])], b = index[world.graph.id(ends[1])];
      edges_.emplace(std::max(a, b), Link{edge, a, b});
    }
  }

  bool at_end() const { return poses_.size() == all_.size(); }
  std::size_t poses() const { return poses_.size(); }

  void append() {
    const std::size_t k = poses_.size();
    poses_.push_back(graph.add_vertex(world_.graph.estimate(world_.graph.typed<Pose>(all_[k]))));
    if (k == 0) graph.fix(poses_[0]);
    const auto [begin, end] = edges_.equal_range(k);
    for (auto link = begin; link != end; ++link) {
      const auto& [edge, a, b] = link->second;
      graph.add_edge(world_.graph.measurement(EdgeHandle<Between<Pose>>{edge}), information(edge), poses_[a],
                     poses_[b]);
    }
  }

  /// Returns the last `size` poses.
  std::vector<VertexRef> window(std::size_t size) const {
    return {poses_.end() - static_cast<std::ptrdiff_t>(std::min(size, poses_.size())), poses_.end()};
  }
  /// Makes the next optimization compute a new plan, because a vertex was fixed since the last one.
  void touch() {
    graph.fix(poses_[1]);
    graph.unfix(poses_[1]);
  }

  Graph graph;

 private:
  struct Link {
    EdgeRef edge;
    std::size_t a, b;
  };

  Information information(EdgeRef edge) const {
    const detail::InformationView omega = world_.graph.information(edge);
    Eigen::MatrixXd full(omega.rows, omega.rows);
    for (int i = 0; i < omega.rows; ++i) {
      for (int j = 0; j < omega.rows; ++j) full(i, j) = omega(i, j);
    }
    return Information(full);
  }

  const Simulation& world_;
  std::vector<VertexRef> all_;
  std::multimap<std::size_t, Link> edges_;
  std::vector<VertexHandle<Pose>> poses_;
};

template <class Pose>
void measure(World world, int poses) {
  constexpr int kSteps = 300;
  const Simulation simulation = simulate(world, {.poses = poses + kSteps});
  Drive<Pose> extended(simulation), anew(simulation), window(simulation);
  Optimizer optimize_extended(extended.graph), optimize_anew(anew.graph), optimize_window(window.graph);
  std::vector<double> seconds_extended, seconds_anew, seconds_window, ratio;
  Options options{.max_iterations = 1, .threads = 1}, local = options;
  Report report, report_anew, report_window;
  const auto timed = [](Optimizer& optimizer, const Options& how, Report& result) {
    const double begin = cpu_seconds();
    optimizer.set_options(how);
    optimizer.run(result);
    return cpu_seconds() - begin;
  };
  int extensions = 0;
  while (!extended.at_end()) {
    for (Drive<Pose>* drive : {&extended, &anew, &window}) drive->append();
    if (extended.poses() + kSteps < simulation.graph.vertex_count()) {
      if (extended.poses() % 100 != 0) continue;
      for (Optimizer* optimizer : {&optimize_extended, &optimize_anew, &optimize_window}) {
        optimizer->set_options({.threads = 1});
        optimizer->run(report);
      }
      continue;
    }
    anew.touch();
    local.vertices = window.window(10);
    seconds_extended.push_back(timed(optimize_extended, options, report));
    seconds_anew.push_back(timed(optimize_anew, options, report_anew));
    seconds_window.push_back(timed(optimize_window, local, report_window));
    ratio.push_back(seconds_anew.back() / seconds_extended.back());
    extensions += report.plan_extended ? 1 : 0;
  }
  std::printf("| %s | %u | %u | %.3f | %.3f | %.2f | %.3f | %d of %zu |\n",
              std::string(to_string(world)).c_str(), report.vertices, report.edges,
              1e3 * median(seconds_anew), 1e3 * median(seconds_extended), median(ratio),
              1e3 * median(seconds_window), extensions, ratio.size());
}

}  // namespace
}  // namespace boxplus::bench

int main(int argc, char** argv) {
  using namespace boxplus;
  const int poses = argc > 1 ? std::atoi(argv[1]) : 2000;
  std::printf(
      "Median CPU time of a step with one iteration on one thread [ms]\n\n"
      "| World | Poses | Edges | New plan | Extended plan | New / extended | Window of 10 | Plans extended "
      "|\n"
      "|---|---|---|---|---|---|---|---|\n");
  bench::measure<SE2>(World::kManhattan, poses);
  bench::measure<SE2>(World::kStreets, poses);
  bench::measure<SE3>(World::kSphere, poses);
}
