// SPDX-License-Identifier: BSD-3-Clause
// Measures one step of a robot that optimizes while it drives (docs/live.md). A step adds a pose and its
// edges, and then optimizes. The benchmark compares the CPU time of three ways: an update of a Smoother, and
// one iteration of an Optimizer over all vertices, or over a window of the last poses. The Optimizers make a
// new plan in each step: an elimination order and a memory layout of H.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"
#include "boxplus/incremental/smoother.h"
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
    poses_.push_back(graph.add_vertex(guess(k)));
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

  Graph graph;

 private:
  struct Link {
    EdgeRef edge;
    std::size_t a, b;
  };

  /// The estimate of the last pose, moved by the odometry.
  Pose guess(std::size_t k) const {
    const auto by_odometry = [&](std::size_t i) {
      return world_.graph.estimate(world_.graph.typed<Pose>(all_[i]));
    };
    if (k == 0) return by_odometry(0);
    return graph.estimate(poses_.back()) * by_odometry(k - 1).inverse_times(by_odometry(k));
  }

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

/// The CPU time of f() in seconds.
template <class F>
double timed(F&& f) {
  const double begin = cpu_seconds();
  f();
  return cpu_seconds() - begin;
}

template <class Pose>
void measure(World world, int poses) {
  constexpr int kSteps = 300, kStepsBetweenOptima = 100;
  const Simulation simulation = simulate(world, {.poses = poses + kSteps});
  Drive<Pose> live(simulation), anew(simulation), window(simulation);
  Smoother smoother(live.graph);
  Optimizer optimize_anew(anew.graph), optimize_window(window.graph);
  std::vector<double> seconds_live, seconds_anew, seconds_window, ratio;
  const Options options{.max_iterations = 1, .threads = 1};
  Options local = options;
  Report report, report_window;
  while (!anew.at_end()) {
    for (Drive<Pose>* drive : {&live, &anew, &window}) drive->append();
    if (anew.poses() + kSteps < simulation.graph.vertex_count()) {
      if (anew.poses() % kStepsBetweenOptima != 0) continue;
      smoother.update();
      for (Optimizer* optimizer : {&optimize_anew, &optimize_window}) {
        optimizer->set_options({.threads = 1});
        optimizer->run(report);
      }
      optimize_anew.set_options(options);
      continue;
    }
    local.vertices = window.window(10);
    seconds_live.push_back(timed([&] { smoother.update(); }));
    seconds_anew.push_back(timed([&] { optimize_anew.run(report); }));
    seconds_window.push_back(timed([&] {
      optimize_window.set_options(local);
      optimize_window.run(report_window);
    }));
    ratio.push_back(seconds_anew.back() / seconds_live.back());
  }
  std::printf("| %s | %u | %u | %.3f | %.3f | %.2f | %.3f |\n", std::string(to_string(world)).c_str(),
              report.vertices, report.edges, 1e3 * median(seconds_live), 1e3 * median(seconds_anew),
              median(ratio), 1e3 * median(seconds_window));
}

}  // namespace
}  // namespace boxplus::bench

int main(int argc, char** argv) {
  using namespace boxplus;
  const int poses = argc > 1 ? std::atoi(argv[1]) : 2000;
  std::printf(
      "Median CPU time of a step on one thread [ms]\n\n"
      "| World | Poses | Edges | Smoother | New plan | New plan / Smoother | Window of 10 |\n"
      "|---|---|---|---|---|---|---|\n");
  bench::measure<SE2>(World::kManhattan, poses);
  bench::measure<SE2>(World::kStreets, poses);
  bench::measure<SE3>(World::kSphere, poses);
}
