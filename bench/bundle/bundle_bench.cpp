// SPDX-License-Identifier: BSD-3-Clause
// Compares bundle adjustment in boxplus with Ceres. Prints tables that `make bench` appends to
// bench/RESULTS.md.
//
//     bundle_bench FOLDER          compares on the BAL files of FOLDER/bal
//     bundle_bench forms FOLDER    compares only the forms of a problem
//     bundle_bench form N FILE     runs form N of FILE once, to measure its memory
//     bundle_bench collections     compares on photo collections only
//     bundle_bench ceres FILE      optimizes FILE once by Ceres with DENSE_SCHUR, to measure its memory
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "boxplus/boxplus.h"
#include "boxplus/testing/simulate_bundle.h"
#include "bundle/bundle_forms.h"
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
    run.iterations = record.iteration;
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

/// Runs the iterations in which forms are compared.
Report run_form(Graph& graph) {
  return optimize(graph, {.start = Start::kCurrent, .max_iterations = 5, .noise_tolerance = 0, .threads = 1});
}

void compare_forms(const std::string& name, const std::string& programs, const std::string& path) {
  const BundleProblem problem = read_bundle_problem(path);
  std::vector<Graph> graphs;
  for (const BundleForm form : kBundleForms) graphs.push_back(make_bundle_graph(problem, form));
  std::vector<Contestant> contestants;
  for (Graph& graph : graphs) {
    contestants.emplace_back([&] {
      graph.push();
      const Report report = run_form(graph);
      graph.pop();
      double steps = 0;  // with those that were rejected, which take another linearization in large problems
      for (const IterationRecord& record : report.records) steps += record.tries;
      const Report::Timings& time = report.time;
      const double seconds = time.linearize_s + time.factorize_s + time.solve_s + time.evaluate_s;
      return Figures{1e9 * seconds / (steps * static_cast<double>(report.edges))};
    });
  }
  const std::vector<Figures> medians = interleaved_medians(contestants, {.least = 7, .most = 15});
  fmt::print("\n| {} | ns | × | MiB | × |\n|---|--:|--:|--:|--:|\n", name);
  double first_mib = 0;
  for (std::size_t k = 0; k < medians.size(); ++k) {
    const double mib = run_process({programs + "/bundle_bench", "form", std::to_string(k), path}).peak_mib;
    if (k == 0) first_mib = mib;
    fmt::print("| {} | {:.0f} | {:.2f} | {:.1f} | {:.2f} |\n", describe(kBundleForms[k]), medians[k][0],
               medians[k][0] / medians[0][0], mib, mib / first_mib);
  }
}

/// Compares the forms in which a program can state a problem. Each form runs the same number of iterations.
void compare_all_forms(const std::string& programs, const std::filesystem::path& folder) {
  fmt::print(
      "\n### Forms\n\n"
      "ns per observation and step, with one thread; the mean of the steps of the first five iterations,\n"
      "with those that were rejected.\n"
      "MiB is the peak memory of a process that adds the elements and runs these iterations.\n"
      "The columns × are divided by the first row. For all forms, vertices and edges are added by a "
      "program.\n"
      "Principal points are fixed. A camera of the model sees its pixels in the same directions as BAL's\n"
      "camera. The street is simulated, with 300 cameras and 60,000 points.\n");
  for (const BundleFile& file : kFiles) {
    const std::filesystem::path path = folder / "bal" / file.name;
    if (std::filesystem::exists(path)) compare_forms(file.name, programs, path);
  }
  const std::string street =
      (std::filesystem::temp_directory_path() / fmt::format("boxplus-street-{}.bal", getpid())).string();
  write_graph(street, simulate_bundle(BundleShape::kStreet, {.cameras = 300, .points = 60'000}).graph);
  compare_forms("street", programs, street);
  std::filesystem::remove(street);
}

/// Runs one of kBundleForms. The problem itself is gone when the run begins.
void run_form_once(std::size_t form, const std::string& path) {
  if (form >= std::size(kBundleForms)) throw std::runtime_error("expected the number of a form");
  Graph graph = make_bundle_graph(read_bundle_problem(path), kBundleForms[form]);
  const Report report = run_form(graph);
  print_whole_run(report.time.total_s, report.chi2_final);
}

void compare_memory(const std::string& programs, const std::filesystem::path& folder) {
  fmt::print(
      "\n### Memory\n\n"
      "The peak memory of a process that reads the file, optimizes with one thread and ends; boxplus also\n"
      "writes the result. Ceres uses DENSE_SCHUR and autodiff.\n\n"
      "| file | boxplus MiB | Ceres MiB | × |\n|---|--:|--:|--:|\n");
  for (const BundleFile& file : kFiles) {
    const std::string path = folder / "bal" / file.name;
    if (!std::filesystem::exists(path)) continue;
    const double ours = run_process({programs + "/whole_boxplus", path, "/dev/null"}).peak_mib;
    const double ceres = run_process({programs + "/bundle_bench", "ceres", path}).peak_mib;
    fmt::print("| {} | {:.1f} | {:.1f} | {:.2f} |\n", file.name, ours, ceres, ceres / ours);
  }
}

void show_growth(const std::string& programs) {
  fmt::print(
      "\n### Growth\n\n"
      "Simulated streets with 5 observations per point, from their initial estimates until the run ends by\n"
      "itself, with one thread. The memory includes the simulation.\n\n"
      "| cameras | points | observations | plan s | s per iteration | ns per observation | iterations |"
      " converged | chi2 per degree of freedom | peak MiB |\n|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const auto& [cameras, points] :
       {std::pair(20, 6000), {60, 60'000}, {600, 600'000}, {2000, 2'000'000}}) {
    const std::string line =
        output_of({programs + "/simulated_bundle", std::to_string(cameras), std::to_string(points)});
    std::istringstream in(line);
    double observations = 0, plan_s = 0, iteration_s = 0, chi2 = 0, peak_mib = 0;
    int iterations = 0;
    std::string converged;
    if (!(in >> observations >> plan_s >> iteration_s >> iterations >> chi2 >> converged >> peak_mib))
      throw std::runtime_error("simulated_bundle: cannot read '" + line + "'");
    fmt::print("| {} | {} | {:.0f} | {:.2f} | {:.3f} | {:.0f} | {} | {} | {:.3f} | {:.0f} |\n", cameras,
               points, observations, plan_s, iteration_s, 1e9 * iteration_s / observations, iterations,
               converged, chi2, peak_mib);
  }
}

/// A photo collection like the data sets Trafalgar-257 and Final-961.
struct Collection {
  BundleOptions options;
  bool compares_all;  ///< with all solvers of Ceres; otherwise with ITERATIVE_SCHUR, which is the fastest
};

/// Photo collections, until the cost is within 1e-3 of the lowest one.
void compare_collections() {
  constexpr double kClose = 1e-3;
  const Collection collections[] = {{{.cameras = 257, .points = 65'000, .track_length = 3.5}, true},
                                    {{.cameras = 961, .points = 200'000, .track_length = 10.5}, false}};
  fmt::print(
      "\n### Photo collections\n\n"
      "Simulated (`simulate ba --shape collection`): nearly all cameras share points. Time until the cost "
      "is\n"
      "within 1e-3 of the lowest one, with one thread and automatic derivatives in Ceres. The phases are in "
      "ns\n"
      "per observation and iteration. The share of the plan is that of boxplus's whole run.\n");
  const std::string path =
      (std::filesystem::temp_directory_path() / fmt::format("boxplus-collection-{}.bal", getpid())).string();
  for (const Collection& collection : collections) {
    write_graph(path, simulate_bundle(BundleShape::kCollection, collection.options).graph);
    const BundleProblem problem = read_bundle_problem(path);
    Graph ours = read_graph(path).graph;
    std::filesystem::remove(path);
    const auto observations = static_cast<double>(problem.observations.size());
    ours.push();
    const Report whole = optimize(ours, {.start = Start::kCurrent, .threads = 1});
    ours.pop();
    const double target = whole.chi2_final / 2 * (1 + kClose);
    CeresBundle ceres(problem, false);
    std::vector<std::string> names{"boxplus"};
    std::vector<Contestant> contestants{[&] { return figures_of(run_ours(ours, 1, target), observations); }};
    for (const CeresBundleSettings& settings : kSettings) {
      if (settings.analytic || (!collection.compares_all && settings.solver != Solver::kIterativeSchur))
        continue;
      names.push_back("Ceres, " + std::string(settings.name));
      contestants.emplace_back(
          [&, settings] { return figures_of(ceres.run(settings.solver, 1, target), observations); });
    }
    const std::vector<Figures> medians =
        interleaved_medians(contestants, {.least = 1, .most = 3, .enough_s = 30});
    fmt::print("\n{} cameras, {} points, {} observations; the plan takes {:.1f} % of the run.\n\n",
               problem.cameras.size(), problem.points.size(), problem.observations.size(),
               100 * whole.time.plan_s / whole.time.total_s);
    fmt::print(
        "| solver | ms | iterations | cost | linearize | solve | evaluate | × |\n"
        "|---|--:|--:|--:|--:|--:|--:|--:|\n");
    for (std::size_t k = 0; k < medians.size(); ++k) print_row(names[k], medians[k], medians[0][0]);
  }
}

void run_ceres_once(const std::string& path) {
  const BundleRun run = CeresBundle(read_bundle_problem(path), false).run(Solver::kDenseSchur, 1, 0);
  print_whole_run(run.seconds, 2 * run.cost);
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  using namespace boxplus::bench;
  if (count == 3 && std::string(words[1]) == "ceres") {
    run_ceres_once(words[2]);
    return 0;
  }
  if (count == 4 && std::string(words[1]) == "form") {
    run_form_once(std::stoul(words[2]), words[3]);
    return 0;
  }
  if (count == 3 && std::string(words[1]) == "forms") {
    compare_all_forms(std::filesystem::read_symlink("/proc/self/exe").parent_path(), words[2]);
    return 0;
  }
  if (count == 2 && std::string(words[1]) == "collections") {
    compare_collections();
    return 0;
  }
  if (count != 2) {
    fmt::print(stderr, "bundle_bench: expected the folder of the data\n");
    return 2;
  }
  require_open_blas_with_one_thread();
  const std::filesystem::path folder = words[1];
  const std::string programs = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  compare_all(folder);
  compare_all_forms(programs, folder);
  compare_memory(programs, folder);
  show_growth(programs);
  compare_collections();
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "bundle_bench: {}\n", error.what());
  return 1;
}
