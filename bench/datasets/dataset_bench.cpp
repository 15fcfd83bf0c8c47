// SPDX-License-Identifier: BSD-3-Clause
// Compares boxplus with CHOLMOD and Ceres on public graphs, and prints the tables of bench/RESULTS.md.
//
//     dataset_bench FOLDER COMMIT [NAME…]
//
// FOLDER contains the graph files that datasets.cpp lists, and COMMIT is the commit of the sources. If NAMEs
// are given, only these files are measured, and no simulated graphs. Progress is printed to stderr.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "boxplus/testing/simulate.h"
#include "datasets/interleave.h"
#include "datasets/machine.h"
#include "datasets/open_blas.h"
#include "datasets/results.h"

namespace boxplus::bench {
namespace {

struct Arguments {
  std::string programs, folder, commit;
  std::vector<std::string> names;

  bool wants(const std::string& name) const {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  }
};

Arguments parse(int count, char** words) {
  if (count < 3) throw std::runtime_error("expected FOLDER COMMIT [NAME…]");
  Arguments arguments{std::filesystem::read_symlink("/proc/self/exe").parent_path(),
                      words[1],
                      words[2],
                      {words + 3, words + count}};
  for (const std::string& name : arguments.names) {
    const auto known = [&](const Dataset& dataset) { return dataset.name() == name; };
    if (std::none_of(datasets().begin(), datasets().end(), known)) {
      throw std::runtime_error("there is no data set with the name " + name);
    }
  }
  return arguments;
}

/// Returns true if the native API and the g2o API are compared on this file.
bool compares_faces(const std::string& name) {
  return name == "sphere2500" || name == "torus3D";
}

DatasetResults measure(const Dataset& dataset, const Arguments& arguments) {
  DatasetResults results{.dataset = dataset};
  const std::string path = std::filesystem::path(arguments.folder) / dataset.path;
  try {
    GraphFile file = read_anchored(path);
    results.linear = run_linear_comparison(file.graph);
    results.solve = run_solve_comparison(file.graph, dataset.target());
    results.whole =
        run_whole_comparison(arguments.programs, path, results.solve->ceres_settings_index, dataset.target());
    results.threads = run_thread_comparison(file.graph);
    if (compares_faces(dataset.name())) results.faces = run_face_comparison(path);
  } catch (const std::exception& error) {
    results.trouble = error.what();
    fmt::print(stderr, "{}: {}\n", dataset.name(), error.what());
  }
  return results;
}

double median_dgemm_rate() {
  return interleaved_medians({[] { return Figures{dgemm_rate()}; }})[0][0];
}

Results measure_all(const Arguments& arguments) {
  Results results{.machine = describe_machine(arguments.commit)};
  results.dgemm_rate = median_dgemm_rate();
  for (const Dataset& dataset : datasets()) {
    if (!arguments.wants(dataset.name())) continue;
    fmt::print(stderr, "{}\n", dataset.name());
    results.datasets.push_back(measure(dataset, arguments));
  }
  if (!arguments.names.empty()) return results;
  for (const int poses : {200, 300, 400, kLargeTorus}) {
    fmt::print(stderr, "torus of {} poses\n", poses);
    Simulation torus = simulate(World::kTorus, {.poses = poses});
    results.tori[poses] = run_thread_comparison(torus.graph);
  }
  results.scale = run_scale(arguments.programs);
  return results;
}

void print(const Results& results) {
  fmt::print(
      "# Results of the benchmarks\n\n"
      "Written by the latest run of `make bench`. All figures are from this run. boxplus, CHOLMOD\n"
      "and Ceres took turns. Unless stated otherwise, figures are medians of at least five repetitions\n"
      "with one thread.\n"
      "× is the factor by which boxplus is faster (or needs less memory).\n\n| | |\n|---|---|\n");
  for (const auto& [what, value] : results.machine) fmt::print("| {} | {} |\n", what, value);
  fmt::print("\n{}{}", goals_of(results), tables_of(results));
}

}  // namespace
}  // namespace boxplus::bench

int main(int count, char** words) try {
  using namespace boxplus::bench;
  require_open_blas_with_one_thread();
  const Results results = measure_all(parse(count, words));
  print(results);
  const auto failed = [](const DatasetResults& result) { return !result.trouble.empty(); };
  return std::any_of(results.datasets.begin(), results.datasets.end(), failed) ? 1 : 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "dataset_bench: {}\n", error.what());
  return 1;
}
