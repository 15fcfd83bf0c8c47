// SPDX-License-Identifier: BSD-3-Clause
// Measures boxplus and its peers on public graphs, side by side in one run.
#include <fmt/core.h>

#include <exception>
#include <filesystem>

#include "datasets/datasets.h"
#include "datasets/linear_duel.h"
#include "datasets/open_blas.h"
#include "datasets/solve_duel.h"

using namespace boxplus;
using namespace boxplus::bench;

int main(int, char** argv) try {
  require_open_blas_with_one_thread();
  fmt::print("{}: {:.1f} GFLOP/s\n", open_blas_version(), dgemm_rate());
  for (const Dataset& dataset : datasets()) {
    GraphFile file = read_anchored((std::filesystem::path(argv[1]) / dataset.path).string());
    const SolveDuel d = run_solve_duel(file.graph, dataset.target());
    const auto show = [](const char* name, const SolveFigures& f) {
      fmt::print("   {:10} arrival {:9.2f} ms lin {:8.3f} it {:8.3f} n {} chi2 {:.9g}\n", name,
                 1e3 * f.arrival_s, 1e3 * f.linearize_s, 1e3 * f.iteration_s, f.iterations, f.chi2);
    };
    fmt::print("{} {:.12g} {:.1e} {}\n", dataset.name(), d.chi2_initial, d.start_difference,
               d.ceres_settings);
    show("ours", d.ours);
    show("auto", d.ours_automatic);
    show("analytic", d.analytic);
    show("autodiff", d.autodiff);
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "dataset_bench: {}\n", error.what());
  return 1;
}
