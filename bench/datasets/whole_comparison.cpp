// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/whole_comparison.h"

#include <unistd.h>

#include <filesystem>

#include "datasets/interleave.h"

namespace boxplus::bench {
namespace {

Figures numbers(const WholeRun& run) {
  return {run.seconds, run.chi2, run.peak_mib};
}
WholeRun whole_run(const Figures& figures) {
  return {figures[0], figures[1], figures[2]};
}

}  // namespace

WholeComparison run_whole_comparison(const std::string& programs, const std::string& file, int ceres_settings,
                                     double target) {
  const std::string output =
      std::filesystem::temp_directory_path() / ("boxplus_bench_" + std::to_string(getpid()) + ".g2o");
  const auto ours = [&] { return run_process({programs + "/whole_boxplus", file, output}); };
  const auto ceres = [&] {
    return run_process({programs + "/whole_ceres", file, output, std::to_string(ceres_settings)});
  };
  const WholeRun first = ceres();
  std::vector<Contestant> contestants{[&] { return numbers(ours()); }};
  if (first.chi2 <= target) contestants.emplace_back([&] { return numbers(ceres()); });
  const std::vector<Figures> medians =
      interleaved_medians(contestants, {.least = 5, .most = 9, .enough_s = 2});
  std::filesystem::remove(output);
  return {whole_run(medians.front()), medians.size() > 1 ? whole_run(medians.back()) : first};
}

}  // namespace boxplus::bench
