// SPDX-License-Identifier: BSD-3-Clause
// Measures boxplus and its peers on public graphs, side by side in one run.
#include <fmt/core.h>

#include <exception>
#include <filesystem>

#include "datasets/datasets.h"
#include "datasets/linear_duel.h"
#include "datasets/open_blas.h"

using namespace boxplus;
using namespace boxplus::bench;

int main(int, char** argv) try {
  require_open_blas_with_one_thread();
  fmt::print("{}: {:.1f} GFLOP/s\n", open_blas_version(), dgemm_rate());
  for (const Dataset& dataset : datasets()) {
    GraphFile file = read_anchored((std::filesystem::path(argv[1]) / dataset.path).string());
    const LinearDuel d = run_linear_duel(file.graph);
    fmt::print(
        "{:28} analyse {:.2f} vs {:.2f} / {:.2f}  factor {:.2f} vs {:.2f} ({}) x{:.2f}  solve {:.2f} vs "
        "{:.2f}  GF/s {:.1f} {:.1f}  diff {:.1e}\n",
        dataset.name(), 1e3 * d.ours.analyze_s, 1e3 * d.cholmod_amd_analyze_s,
        1e3 * d.cholmod_block_amd_analyze_s, 1e3 * d.ours.factorize_s, 1e3 * d.cholmod.factorize_s,
        d.cholmod_settings, d.cholmod.factorize_s / d.ours.factorize_s, 1e3 * d.ours.solve_s,
        1e3 * d.cholmod.solve_s, d.ours.rate(), d.cholmod.rate(), d.largest_difference);
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "dataset_bench: {}\n", error.what());
  return 1;
}
