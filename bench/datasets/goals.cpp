// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "datasets/interleave.h"
#include "datasets/results.h"

namespace boxplus::bench {
namespace {

/// The ratios that a goal bounds, such as the time of a peer (CHOLMOD or Ceres) divided by the time of
/// boxplus.
struct Ratios {
  /// The name of each file and its ratio. The ratio is 0 if only the peer reached the target chi2.
  std::vector<std::pair<std::string, double>> files;
  /// The files on which the peer did not reach the target chi2, or that could not be measured.
  std::vector<std::string> missing;
};

struct Goal {
  std::string text;
  double mean;       ///< the goal for the geometric mean
  double least = 0;  ///< the goal for every single file; 0: no such goal
};

Ratios ratios_of(const Results& results, const std::function<double(const DatasetResults&)>& ratio) {
  Ratios ratios;
  for (const DatasetResults& result : results.datasets) {
    if (!result.dataset.counts) continue;
    const double value = result.linear && result.solve ? ratio(result) : std::nan("");
    if (std::isfinite(value)) {
      ratios.files.emplace_back(result.dataset.name(), value);
    } else {
      ratios.missing.push_back(result.dataset.name());
    }
  }
  return ratios;
}

std::string line_of(const Goal& goal, const Ratios& ratios) {
  std::vector<double> values;
  for (const auto& [file, ratio] : ratios.files) values.push_back(ratio);
  if (values.empty()) return fmt::format("| {} | | | | not measured |\n", goal.text);
  const double mean = geometric_mean(values);
  const auto worst = std::min_element(ratios.files.begin(), ratios.files.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; });
  std::string wanted = fmt::format("{:g}", goal.mean);
  if (goal.least > 0) wanted += fmt::format(", none below {:g}", goal.least);
  std::string verdict = mean >= goal.mean && worst->second >= goal.least ? "met" : "**not met**";
  if (!ratios.missing.empty()) verdict += fmt::format("; without {}", fmt::join(ratios.missing, ", "));
  return fmt::format("| {} | {} | {:.2f} | {:.2f} ({}) | {} |\n", goal.text, wanted, mean, worst->second,
                     worst->first, verdict);
}

std::string linear_goals(const Results& results) {
  const auto linear = [&](const std::function<double(const LinearComparison&)>& ratio) {
    return ratios_of(results, [&](const DatasetResults& result) { return ratio(*result.linear); });
  };
  return line_of({"factorization, against CHOLMOD's fastest configuration", 4, 2.5},
                 linear([](const LinearComparison& d) {
                   return d.cholmod.factorize_s / d.automatic.factorize_s;
                 })) +
         line_of({"the same, all in double", 4, 2.5}, linear([](const LinearComparison& d) {
                   return d.cholmod.factorize_s / d.ours.factorize_s;
                 })) +
         line_of({"factorization and solution", 4, 2.5}, linear([](const LinearComparison& d) {
                   return (d.cholmod.factorize_s + d.cholmod.solve_s) /
                          (d.automatic.factorize_s + d.automatic.solve_s);
                 })) +
         line_of({"analysis, against CHOLMOD with AMD", 3}, linear([](const LinearComparison& d) {
                   return d.cholmod_amd_analyze_s / d.analyze_by_degree_s;
                 })) +
         line_of({"the same, with AMD on blocks", 3}, linear([](const LinearComparison& d) {
                   return d.cholmod_block_amd_analyze_s / d.analyze_by_degree_s;
                 }));
}

std::string solve_goals(const Results& results) {
  const auto solve = [&](const std::function<double(const SolveComparison&)>& ratio) {
    return ratios_of(results, [&](const DatasetResults& result) { return ratio(*result.solve); });
  };
  return line_of(
             {"linearize + assemble, against Ceres's Jacobian evaluation with autodiff", 6},
             solve([](const SolveComparison& d) { return d.autodiff.linearize_s / d.ours.linearize_s; })) +
         line_of({"the same, with analytic edges", 2}, solve([](const SolveComparison& d) {
                   return d.analytic.linearize_s / d.ours.linearize_s;
                 })) +
         line_of({"iteration, against Ceres with analytic edges", 4}, solve([](const SolveComparison& d) {
                   return d.analytic.iteration_s / d.ours.iteration_s;
                 })) +
         line_of({"time until chi2 is within 1e-6 of the best chi2, both from the file's estimates, against "
                  "Ceres's "
                  "fastest configuration",
                  10, 4},
                 solve([](const SolveComparison& d) {
                   return std::min(d.analytic.arrival_s, d.autodiff.arrival_s) / d.ours.arrival_s;
                 })) +
         line_of({"the same, boxplus with Start::kAutomatic", 10, 4}, solve([](const SolveComparison& d) {
                   return std::min(d.analytic.arrival_s, d.autodiff.arrival_s) / d.ours_automatic.arrival_s;
                 }));
}

std::string thread_goal(const Results& results) {
  Ratios ratios;
  for (const DatasetResults& result : results.datasets) {
    const std::string name = result.dataset.name();
    if ((name != "sphere2500" && name != "torus3D") || !result.threads) continue;
    ratios.files.emplace_back(name, result.threads->one_s / result.threads->two_s);
  }
  if (const auto torus = results.tori.find(kLargeTorus); torus != results.tori.end())
    ratios.files.emplace_back("torus of 10 000 poses", torus->second.one_s / torus->second.two_s);
  return line_of({"two threads, against one", 1.25, 1.25}, ratios);
}

/// The goal that a second thread does not slow down the optimization of small files.
std::string slowdown_goal(const Results& results) {
  Ratios ratios;
  for (const DatasetResults& result : results.datasets) {
    if (result.threads)
      ratios.files.emplace_back(result.dataset.name(), result.threads->one_s / result.threads->two_s);
  }
  for (const auto& [poses, comparison] : results.tori)
    ratios.files.emplace_back(fmt::format("torus of {} poses", poses), comparison.one_s / comparison.two_s);
  return line_of({"the same, on every file and simulated torus", 0.95, 0.95}, ratios);
}

/// The goal for the rate of our factorization, as a fraction of the rate of DGEMM.
std::string rate_goal(const Results& results) {
  Ratios ratios;
  for (const DatasetResults& result : results.datasets) {
    const std::string name = result.dataset.name();
    if ((name == "sphere2500" || name == "torus3D") && result.linear)
      ratios.files.emplace_back(name, result.linear->ours.rate() / results.dgemm_rate);
  }
  return line_of({"factorization in double, against DGEMM's rate", 0.35, 0.35}, ratios);
}

/// The goals for large simulated graphs: bounds of time and memory, instead of ratios to a peer.
std::string scale_goals(const Results& results) {
  const auto streets = [&](int poses) -> const ScaleFigures* {
    for (const ScaleResult& result : results.scale) {
      if (result.world == "streets" && result.poses == poses) return &result.figures;
    }
    return nullptr;
  };
  const ScaleFigures *small = streets(10'000), *large = streets(1'000'000);
  if (small == nullptr || large == nullptr) return "";
  const double growth = large->iteration_s / large->vertices / (small->iteration_s / small->vertices);
  const auto line = [](const char* what, const char* wanted, const std::string& measured, bool met) {
    return fmt::format("| {} | {} | {} | – | {} |\n", what, wanted, measured, met ? "met" : "**not met**");
  };
  return line("streets of 1M poses: seconds per iteration", "at most 6",
              fmt::format("{:.2f}", large->iteration_s), large->iteration_s <= 6) +
         line("the same: peak memory from load to write, GiB", "at most 10",
              fmt::format("{:.1f}", large->peak_mib / 1024), large->peak_mib <= 10 * 1024) +
         line("the same: time per pose and iteration, relative to 10k poses", "below 2",
              fmt::format("{:.2f}", growth), growth < 2);
}

/// The goals for the cost of the g2o API: bounds of the ratio of its time to the time of the native API.
std::string face_goals(const Results& results) {
  const auto line = [&](const char* what, double most, double FaceFigures::*figure) {
    double worst = 0;
    std::string file;
    for (const DatasetResults& result : results.datasets) {
      if (!result.faces) continue;
      const double ratio = result.faces->face.*figure / (result.faces->native.*figure);
      if (ratio > worst) file = result.dataset.name();
      worst = std::max(worst, ratio);
    }
    if (file.empty()) return std::string();
    return fmt::format("| {} | at most {:g} | – | {:.2f} ({}) | {} |\n", what, most, worst, file,
                       worst <= most ? "met" : "**not met**");
  };
  return line("the g2o API: time of an iteration, relative to the native API, all threads", 1.25,
              &FaceFigures::iteration_s) +
         line("the same: time of a linearization", 4, &FaceFigures::linearize_s);
}

}  // namespace

std::string goals_of(const Results& results) {
  std::string counted;
  for (const DatasetResults& result : results.datasets) {
    if (result.dataset.counts) counted += (counted.empty() ? "" : ", ") + result.dataset.name();
  }
  return "## Goals\n\n"
         "The columns \"mean\" and \"least\" show the factor by which boxplus is faster than its peer,\n"
         "CHOLMOD or Ceres: the smallest factor of a file, and the geometric mean over\n" +
         counted +
         ".\nEach line leaves out the files on which the peer did not reach the best chi2, and names these "
         "files.\nIf only the peer reached it, the factor is 0.\n\n"
         "| quantity | goal | mean | least | |\n|---|--:|--:|--:|---|\n" +
         linear_goals(results) + rate_goal(results) + solve_goals(results) + thread_goal(results) +
         slowdown_goal(results) + scale_goals(results) + face_goals(results);
}

}  // namespace boxplus::bench
