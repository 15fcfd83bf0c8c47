// SPDX-License-Identifier: BSD-3-Clause
// Measures the g2o API in the optimizations of a visual SLAM system: global and local bundle adjustment, the
// pose of one image, and a similarity between two keyframes. The argument "bundle", "local", "pose" or
// "similarity" repeats one of them on one thread, for a profiler.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "boxplus/base/parallel.h"
#include "datasets/cpu_time.h"
#include "datasets/median.h"
#include "g2o_api/worlds.h"

namespace bench {
namespace {

/// What one run of an optimization measured.
struct Figures {
  double seconds = 0, start_seconds = 0;  ///< of all iterations, and of initializeOptimization()
  int iterations = 0;
  std::size_t edges = 0;
  double chi2 = 0;
};

/// The time on one thread is CPU time, which other processes disturb less.
bool measures_cpu_time = false;

double now() {
  if (measures_cpu_time) return boxplus::bench::cpu_seconds();
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Runs `task` on one thread. All tasks that boxplus starts inside of a task run on the same thread. Measures
/// CPU time meanwhile.
void on_one_thread(const std::function<void()>& task) {
  measures_cpu_time = true;
  boxplus::detail::parallel_tasks(2, [&](int thread) {
    if (thread == 0) task();
  });
  measures_cpu_time = false;
}

Figures run(g2o::SparseOptimizer& optimizer, int iterations) {
  Figures figures;
  const double begin = now();
  optimizer.initializeOptimization(0);
  figures.start_seconds = now() - begin;
  figures.iterations = optimizer.optimize(iterations);
  figures.seconds = now() - begin - figures.start_seconds;
  optimizer.computeActiveErrors();
  figures.chi2 = optimizer.activeRobustChi2();
  figures.edges = optimizer.activeEdges().size();
  return figures;
}

Figures run_bundle() {
  return run(*make_bundle({120, 11'478, 1, 6}), 10);
}
Figures run_local() {
  return run(*make_bundle({30, 3'000, 10, 6}), 10);
}
Figures run_similarity() {
  return run(*make_similarity(200), 10);
}
Figures run_pose() {
  PoseOnly world = make_pose_only(400);
  Figures figures;
  const double begin = now();
  figures.iterations = optimize_pose(world);
  figures.seconds = now() - begin;
  figures.chi2 = world.optimizer->activeRobustChi2();
  figures.edges = world.edges.size();
  return figures;
}

Figures median_of(const std::function<Figures()>& measure, int runs) {
  std::vector<double> seconds, start_seconds;
  Figures figures;
  for (int k = 0; k < runs; ++k) {
    figures = measure();
    seconds.push_back(figures.seconds);
    start_seconds.push_back(figures.start_seconds);
  }
  figures.seconds = boxplus::bench::median(seconds);
  figures.start_seconds = boxplus::bench::median(start_seconds);
  return figures;
}

double per_edge(const Figures& figures) {
  return 1e9 * figures.seconds / (static_cast<double>(figures.edges) * figures.iterations);
}

struct Problem {
  const char *word, *name;
  Figures (*measure)();
  int runs;
};
constexpr Problem kProblems[] = {{"bundle", "global bundle adjustment", run_bundle, 7},
                                 {"local", "local bundle adjustment", run_local, 15},
                                 {"pose", "pose of one image", run_pose, 101},
                                 {"similarity", "similarity of two keyframes", run_similarity, 101}};

void print_row(const Problem& problem) {
  Figures one;
  on_one_thread([&] { one = median_of(problem.measure, problem.runs); });
  const Figures all = median_of(problem.measure, problem.runs);
  std::printf("| %s | %zu | %d | %.1f | %.1f | %.2f | %.3f | %.1f | %.12g |\n", problem.name, one.edges,
              one.iterations, per_edge(one), per_edge(all), one.seconds / all.seconds, 1e3 * one.seconds,
              1e3 * one.start_seconds, all.chi2);
  if (one.chi2 != all.chi2) std::printf("chi2 differs with one thread: %.17g\n", one.chi2);
}

}  // namespace
}  // namespace bench

int main(int count, char** words) {
  using namespace bench;
  if (count > 1) {
    for (const Problem& problem : kProblems) {
      if (std::string(words[1]) == problem.word)
        median_of(problem.measure, count > 2 ? std::atoi(words[2]) : 20);
    }
    return 0;
  }
  std::printf(
      "\n## Visual SLAM through the g2o API\n\n"
      "ns per edge and iteration, with one thread and with %u. An earlier version of boxplus took 310 ns, "
      "and\n"
      "g2o (2024, -march=native) 480 ns, for a global bundle adjustment of this size on one thread.\n\n"
      "| problem | edges | iterations | one thread | all threads | × | ms, one thread | ms to start | chi2 "
      "|\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
      std::thread::hardware_concurrency());
  for (const Problem& problem : kProblems) print_row(problem);
  return 0;
}
