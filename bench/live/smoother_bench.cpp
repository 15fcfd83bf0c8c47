// SPDX-License-Identifier: BSD-3-Clause
// Measures the Smoother:
//
//   smoother_bench FOLDER      replays public graphs, one update per vertex
//   smoother_bench lag STEPS   drives with a fixed lag of 200 poses and landmarks
//   smoother_bench outliers FOLDER   the same with 30 % false loop closures
//   smoother_bench months N    visits the same 2,000 places again and again, N poses in all
#include <malloc.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"
#include "boxplus/incremental/smoother.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/outliers/outliers.h"
#include "boxplus/testing/false_closures.h"
#include "boxplus/types/slam2d.h"
#include "datasets/cpu_time.h"
#include "datasets/median.h"
#include "incremental/road.h"
#include "replay/file_feed.h"
#include "replay/replay_run.h"

namespace boxplus::bench {
namespace {

template <class F>
double timed(F&& f) {
  const double begin = cpu_seconds();
  f();
  return cpu_seconds() - begin;
}

// ---- Replays ----

struct Batch {
  double seconds = 0, iteration = 0, chi2 = 0;
};

/// The time of a whole batch optimization and of one iteration, each the median of several.
Batch measure_batch(const std::string& path) {
  Batch batch;
  std::vector<double> whole, iteration;
  for (int k = 0; k < 7; ++k) {
    GraphFile file = read_graph(path);
    Report report;
    whole.push_back(
        timed([&] { report = optimize(file.graph, {.start = Start::kAutomatic, .threads = 1}); }));
    batch.chi2 = report.chi2_final;
    Optimizer again(file.graph,
                    {.algorithm = AlgorithmKind::kGaussNewton, .max_iterations = 1, .threads = 1});
    again.run(report);
    iteration.push_back(timed([&] { again.run(report); }));
  }
  batch.seconds = median(whole);
  batch.iteration = median(iteration);
  return batch;
}

/// A file that is fed to a replay.
struct FileReplay : app::FileFeed, app::Replay {
  FileReplay(Graph& graph, const SmootherOptions& options) : FileFeed(graph), Replay(graph, options) {}
  bool is_done() const { return done() == steps(); }
  SmootherReport step() {
    add(done());
    return Replay::step();
  }
};

void replay_file(const std::string& name, const std::string& path) {
  constexpr std::size_t kBetweenChecks = 100;
  const Batch batch = measure_batch(path);
  double excess = 0, with_marginals = 0;
  {  // not timed
    GraphFile file = read_graph(path);
    FileReplay replay(file.graph, {});
    while (!replay.is_done()) {
      replay.step();
      if (replay.done() % kBetweenChecks != 0) continue;
      Graph copy = file.graph;
      const double optimum = optimize(copy, {.threads = 1}).chi2_final;
      if (optimum > 1e-12) excess = std::max(excess, replay.chi2() / optimum - 1);
    }
  }
  GraphFile file = read_graph(path);
  FileReplay replay(file.graph, {});
  while (!replay.is_done()) replay.step();
  replay.finish();
  {
    GraphFile again = read_graph(path);
    const std::vector<VertexRef> vertices = again.graph.all_vertices();
    FileReplay marginals(again.graph, {});
    while (!marginals.is_done()) {
      if (!marginals.step().converged() || marginals.done() < 3) continue;
      with_marginals +=
          timed([&] { (void)marginals.smoother().covariance({vertices[marginals.done() - 1]}); });
    }
  }
  const std::vector<double>& seconds = replay.seconds();
  const double worst = *std::max_element(seconds.begin(), seconds.end()), total = replay.totals().seconds;
  std::printf("| %s | %zu | %.1f | %.3f | %.0f | %.1f | %.2f | %.1f | %.1e | %.1e | %.0f %% |\n",
              name.c_str(), replay.steps(), 1e3 * batch.seconds, total, total / batch.seconds,
              1e6 * median(seconds), 1e3 * worst, worst / batch.iteration, excess,
              replay.chi2() / batch.chi2 - 1, 100 * with_marginals / total);
  std::fflush(stdout);
}

void replay_all(const std::string& folder) {
  std::printf(
      "\n## Live\n\nOne update per vertex, on one thread. \"Batch\" is optimize() of the complete graph, "
      "\"iteration\" "
      "one "
      "iteration of it.\n\n"
      "| Graph | Steps | Batch [ms] | Replay [s] | Replay / batch | Median step [µs] | Worst step [ms] | "
      "Worst / "
      "iteration | Excess of chi2, every 100th step | Excess at the end | Marginal of the newest pose adds "
      "|\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  const std::vector<std::pair<std::string, std::string>> files{
      {"intel", "posegraph2d/intel_1728.g2o"},
      {"M3500", "posegraph2d/M3500.g2o"},
      {"parking-garage", "posegraph3d/parking-garage.g2o"},
      {"city10000", "posegraph2d/city10000.g2o"},
      {"w10000", "posegraph2d/w10000.graph"},
      {"sphere2500", "posegraph3d/sphere2500.g2o"},
      {"torus3D", "posegraph3d/torus3D.g2o"},
      {"victoriaPark", "landmark2d/victoriaPark-full.g2o"}};
  for (const auto& [name, path] : files) replay_file(name, folder + "/" + path);
}

// ---- False closures ----

/// Adds 30 % false closures, and compares the verdicts at the end of a replay with those of find_outliers().
void replay_false_closures(const std::string& name, const std::string& path) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    GraphFile file = read_graph(path);
    Graph& graph = file.graph;
    (void)optimize(graph, {.start = Start::kAutomatic});
    const std::vector<EdgeRef> added = add_false_closures(graph, {.fraction = 0.3, .seed = seed});
    Graph whole = graph;
    const OutlierReport batch = find_outliers(whole, {.options = {.threads = 1}});
    FileReplay replay(graph, {.sets_outliers_aside = true});
    while (!replay.is_done()) replay.step();
    replay.finish();
    const auto missed = [&](auto&& is_rejected) {
      return std::count_if(added.begin(), added.end(), [&](EdgeRef edge) { return !is_rejected(edge); });
    };
    const std::vector<EdgeRef> aside = replay.smoother().set_aside();
    std::vector<EdgeRef> rejected;
    for (const EdgeVerdict& verdict : batch.verdicts) {
      if (verdict.weight == 0) rejected.push_back(verdict.edge);
    }
    const auto in = [](const std::vector<EdgeRef>& list) {
      return [&list](EdgeRef edge) { return std::find(list.begin(), list.end(), edge) != list.end(); };
    };
    std::printf("| %s | %d | %zu | %td / %zu | %td / %zu | %.6g / %.6g | %.2f | %.1f |\n", name.c_str(),
                static_cast<int>(seed), added.size(), missed(in(aside)),
                aside.size() + missed(in(aside)) - added.size(), missed(in(rejected)),
                rejected.size() + missed(in(rejected)) - added.size(), replay.chi2(), batch.report.chi2_final,
                replay.totals().seconds,
                1e3 * *std::max_element(replay.seconds().begin(), replay.seconds().end()));
    std::fflush(stdout);
  }
}

// ---- Fixed lag ----

void drive_with_lag(long steps) {
  constexpr std::size_t kLag = 200;
  Road road(1, kLag);
  std::printf(
      "| Step | Time per step [µs] | Vertices | Edges | Memory in use [kB] |\n|--:|--:|--:|--:|--:|\n");
  constexpr int kParts = 24;
  for (int part = 0; part < kParts; ++part) {
    const long count = steps * (part + 1) / kParts - steps * part / kParts;
    const double seconds = timed([&] {
      for (long k = 0; k < count; ++k) {
        const SmootherReport report = road.step();
        if (!report.converged()) std::printf("step %ld: %s\n", k, report.message.c_str());
      }
    });
    std::printf("| %ld | %.1f | %zu | %zu | %zu |\n", steps * (part + 1) / kParts,
                1e6 * seconds / static_cast<double>(count), road.graph().vertex_count(),
                road.graph().edge_count(), mallinfo2().uordblks / 1024);
    std::fflush(stdout);
  }
}

// ---- Months ----

/// A robot that mows a field of 40 × 50 cells there and back, again and again. It recognizes the cell of its
/// last visit, and the cell beside it.
void visit_again_and_again(long poses) {
  constexpr long kRows = 40, kColumns = 50, kCells = kRows * kColumns;
  std::mt19937_64 random(1);
  const auto noise = [&](double sigma) { return sigma * std::normal_distribution<>()(random); };
  Graph graph;
  Smoother smoother(graph);
  std::vector<VertexHandle<SE2>> all;
  std::vector<long> last_visit(kCells, -1);
  const auto cell_of = [&](long k) {
    const long there = k % (2 * kCells), i = there < kCells ? there : 2 * kCells - 1 - there;
    const long row = i / kColumns, column = row % 2 == 0 ? i % kColumns : kColumns - 1 - i % kColumns;
    return row * kColumns + column;
  };
  const auto truth = [&](long k) {
    const long cell = cell_of(k);
    return SE2(static_cast<double>(cell % kColumns), static_cast<double>(cell / kColumns), 0);
  };
  std::printf("| Poses | Time per update [µs] | Worst [ms] | Memory in use [MB] |\n|--:|--:|--:|--:|\n");
  double seconds = 0, worst = 0;
  for (long k = 0; k < poses; ++k) {
    const auto measure = [&](long from) {
      const SE2 z = truth(from).inverse() * truth(k) * SE2(noise(0.02), noise(0.02), noise(0.005));
      if (from == k - 1) all.push_back(graph.add_vertex(graph.estimate(all.back()) * z));
      const double weights[] = {2500, 2500, 40000};
      graph.add_edge(Between(z), Information::diagonal(weights), all[static_cast<std::size_t>(from)],
                     all.back());
    };
    if (k == 0) {
      all.push_back(graph.add_vertex(truth(0)));
      graph.fix(all[0]);
    } else {
      measure(k - 1);
    }
    const long cell = cell_of(k);
    for (const long seen : {cell, cell - kColumns}) {
      if (seen >= 0 && last_visit[static_cast<std::size_t>(seen)] >= 0 &&
          last_visit[static_cast<std::size_t>(seen)] < k - 1)
        measure(last_visit[static_cast<std::size_t>(seen)]);
    }
    last_visit[static_cast<std::size_t>(cell)] = k;
    const double time = timed([&] { (void)smoother.update(); });
    seconds += time;
    worst = std::max(worst, time);
    const long part = std::max(1L, poses / 20);
    if ((k + 1) % part != 0) continue;
    std::printf("| %ld | %.1f | %.2f | %zu |\n", k + 1, 1e6 * seconds / static_cast<double>(part),
                1e3 * worst, mallinfo2().uordblks >> 20);
    std::fflush(stdout);
    seconds = worst = 0;
  }
}

}  // namespace
}  // namespace boxplus::bench

int main(int argc, char** argv) {
  using namespace boxplus::bench;
  const std::string what = argc > 1 ? argv[1] : "../shared/data";
  const long number = argc > 2 ? std::atol(argv[2]) : 0;
  if (what == "lag") return drive_with_lag(number > 0 ? number : 20000), 0;
  if (what == "outliers") {
    const std::string folder = argc > 2 ? argv[2] : "../shared/data";
    std::printf(
        "| Graph | Seed | False closures | Live: missed / wrong | Batch: missed / wrong | chi2 live / batch "
        "| Replay "
        "[s] | Worst step [ms] |\n|---|--:|--:|--:|--:|--:|--:|--:|\n");
    replay_false_closures("M3500", folder + "/posegraph2d/M3500.g2o");
    replay_false_closures("sphere2500", folder + "/posegraph3d/sphere2500.g2o");
    return 0;
  }
  if (what == "months") return visit_again_and_again(number > 0 ? number : 20000), 0;
  replay_all(what);
}
