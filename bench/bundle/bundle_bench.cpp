// SPDX-License-Identifier: BSD-3-Clause
// Compares bundle adjustment in boxplus with Ceres. Prints tables that `make bench` appends to
// bench/RESULTS.md.
//
//     bundle_bench FOLDER          compares on the BAL files of FOLDER/bal
//     bundle_bench one FILE        optimizes FILE once by boxplus, for a measurement of memory
//     bundle_bench ceres FILE      the same by Ceres with DENSE_SCHUR
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "boxplus/boxplus.h"
#include "bundle/ceres_bundle.h"
#include "datasets/interleave.h"
#include "datasets/open_blas.h"
#include "datasets/whole_run.h"

namespace boxplus::bench {
namespace {

struct BundleFile {
  const char* name;
  double best_cost;  ///< the lowest cost that any solver is known to reach, ½ Σ ‖e‖²
};
constexpr BundleFile kFiles[] = {{"problem-16-22106-pre.txt", 18033.9034},
                                 {"problem-21-11315-pre.txt", 30378.6357},
                                 {"problem-49-7776-pre.txt", 13344.2497}};

/// A run ends within this relative distance of the best cost.
constexpr double kWithin = 1e-6;

using Solver = CeresBundleSettings::Solver;
constexpr CeresBundleSettings kSettings[] = {{"DENSE_SCHUR, autodiff", Solver::kDenseSchur, false},
                                             {"SPARSE_SCHUR, autodiff", Solver::kSparseSchur, false},
                                             {"ITERATIVE_SCHUR, autodiff", Solver::kIterativeSchur, false},
                                             {"DENSE_SCHUR, by hand", Solver::kDenseSchur, true},
                                             {"SPARSE_SCHUR, by hand", Solver::kSparseSchur, true},
                                             {"ITERATIVE_SCHUR, by hand", Solver::kIterativeSchur, true}};

BundleRun run_ours(Graph& graph, int threads, double target) {
  BundleRun run;
  Options options{.algorithm = AlgorithmKind::kLevenbergMarquardt, .threads = threads};
  options.start = Start::kCurrent;
  options.max_iterations = 200;
  options.callback = [&](const IterationRecord& record) {
    run.seconds = record.time_s;
    run.iterations = record.iteration + 1;
    return record.chi2 / 2 > target;
  };
  graph.push();
  const Report report = optimize(graph, options);
  graph.pop();
  run.cost = report.chi2_final / 2;
  run.iterations_run = report.iterations;
  run.linearize_s = report.time.linearize_s;
  run.solve_s = report.time.factorize_s + report.time.solve_s;
  run.evaluate_s = report.time.evaluate_s;
  return run;
}

/// The figures of a run: seconds, cost, iterations, and ns per observation and iteration of each phase.
Figures figures_of(const BundleRun& run, double observations) {
  const double nanoseconds = 1e9 / (observations * std::max(1, run.iterations_run));
  return {run.seconds,
          run.cost,
          static_cast<double>(run.iterations),
          run.linearize_s * nanoseconds,
          run.solve_s * nanoseconds,
          run.evaluate_s * nanoseconds};
}

void print_row(const std::string& name, const Figures& f, double ours_s) {
  fmt::print("| {} | {:.1f} | {:.0f} | {:.4f} | {:.0f} | {:.0f} | {:.0f} | {:.2f} |\n", name, 1e3 * f[0],
             f[2], f[1], f[3], f[4], f[5], f[0] / ours_s);
}

/// The ratios of one file: how many times as long as boxplus the fastest configurations of Ceres take.
struct Ratios {
  double autodiff = std::numeric_limits<double>::infinity(), any = autodiff, two_threads = 0, phases = 0;
};

Ratios compare(const std::string& path, const BundleFile& file) {
  const double target = file.best_cost * (1 + kWithin);
  const BundleProblem problem = read_bundle_problem(path);
  GraphFile ours = read_graph(path);
  CeresBundle automatic(problem, false), by_hand(problem, true);
  const auto observations = static_cast<double>(problem.observations.size());
  std::vector<Contestant> contestants{
      [&] { return figures_of(run_ours(ours.graph, 1, target), observations); },
      [&] { return figures_of(run_ours(ours.graph, 2, target), observations); }};
  for (const CeresBundleSettings& settings : kSettings) {
    contestants.emplace_back([&, settings] {
      return figures_of((settings.analytic ? by_hand : automatic).run(settings.solver, 1, target),
                        observations);
    });
  }
  const std::vector<Figures> medians =
      interleaved_medians(contestants, {.least = 5, .most = 9, .enough_s = 60});
  fmt::print("\n{}: {} cameras, {} points, {} observations.\n\n", file.name, problem.cameras.size(),
             problem.points.size(), problem.observations.size());
  fmt::print(
      "| solver | ms | iterations | cost | linearize | solve | evaluate | × |\n"
      "|---|--:|--:|--:|--:|--:|--:|--:|\n");
  const double seconds = medians[0][0];
  print_row("boxplus, one thread", medians[0], seconds);
  print_row("boxplus, two threads", medians[1], seconds);
  Ratios ratios;
  for (std::size_t k = 0; k < std::size(kSettings); ++k) {
    const Figures& peer = medians[k + 2];
    print_row("Ceres, " + std::string(kSettings[k].name), peer, seconds);
    if (!kSettings[k].analytic) ratios.autodiff = std::min(ratios.autodiff, peer[0] / seconds);
    ratios.any = std::min(ratios.any, peer[0] / seconds);
  }
  ratios.two_threads = seconds / medians[1][0];
  ratios.phases = (medians[2][3] + medians[2][4]) / (medians[0][3] + medians[0][4]);
  return ratios;
}

void compare_all(const std::filesystem::path& folder) {
  fmt::print(
      "\n## Bundle adjustment\n\n"
      "Time until the cost ½ Σ ‖e‖² is within 1e-6 of the best known cost, from the same start, with one\n"
      "thread unless said. The phases are in ns per observation and iteration: linearize (Jacobians; in\n"
      "boxplus also the normal equations), solve (elimination and solution of the linear system; in Ceres\n"
      "also the normal equations), and evaluate. The last column is the time divided by that of boxplus\n"
      "with one thread.\n");
  std::vector<double> autodiff, any, two_threads;
  for (const BundleFile& file : kFiles) {
    const std::filesystem::path path = folder / "bal" / file.name;
    if (!std::filesystem::exists(path)) {
      fmt::print("\n{} is missing.\n", file.name);
      continue;
    }
    const Ratios ratios = compare(path, file);
    autodiff.push_back(ratios.autodiff);
    any.push_back(ratios.any);
    two_threads.push_back(ratios.two_threads);
    fmt::print(
        "\nThe fastest Ceres takes {:.2f} times as long with autodiff, and {:.2f} times as long at all. Two\n"
        "threads are {:.2f} times as fast as one. Linearization and solution take Ceres (DENSE_SCHUR with\n"
        "autodiff) {:.2f} times as long.\n",
        ratios.autodiff, ratios.any, ratios.two_threads, ratios.phases);
  }
  fmt::print("\nGeometric means: {:.2f} (autodiff), {:.2f} (any), {:.2f} (two threads).\n",
             geometric_mean(autodiff), geometric_mean(any), geometric_mean(two_threads));
}

void run_once(const std::string& solver, const std::string& path) {
  if (solver == "ceres") {
    const BundleRun run = CeresBundle(read_bundle_problem(path), false).run(Solver::kDenseSchur, 1, 0);
    return print_whole_run(run.seconds, 2 * run.cost);
  }
  GraphFile file = read_graph(path);
  const BundleRun run = run_ours(file.graph, 1, 0);
  print_whole_run(run.seconds, 2 * run.cost);
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  using namespace boxplus::bench;
  if (count == 3) {
    run_once(words[1], words[2]);
    return 0;
  }
  if (count != 2) {
    fmt::print(stderr, "bundle_bench: expected the folder of the data\n");
    return 2;
  }
  require_open_blas_with_one_thread();
  compare_all(words[1]);
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bundle_bench: {}\n", error.what());
  return 1;
}
