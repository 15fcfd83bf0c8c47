// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/solve_comparison.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "boxplus/optimize/optimizer.h"
#include "datasets/ceres/ceres_peer.h"
#include "datasets/graph_numbers.h"
#include "datasets/interleave.h"
#include "datasets/median.h"

namespace boxplus::bench {
namespace {

/// If Ceres does not reach the target, this number of iterations is enough to measure the time of one.
constexpr int kIterationsWhenStuck = 12;

Figures numbers(const SolveFigures& f) {
  return {f.arrival_s, f.linearize_s, f.iteration_s, f.iterations, f.chi2};
}

SolveFigures figures(const Figures& f) {
  return {f[0], f[1], f[2], f[3], f[4]};
}

double median_iteration(const Report& report) {
  std::vector<double> seconds;
  double before = report.time.plan_s + report.time.start_s;
  for (const IterationRecord& record : report.records) {
    seconds.push_back(record.time_s - before);
    before = record.time_s;
  }
  if (seconds.size() > 1) seconds.erase(seconds.begin());  // because the first iteration touches new memory
  return seconds.empty() ? 0 : median(seconds);
}

/// Optimizes from the current estimates, and restores them afterwards.
SolveFigures run_ours(Graph& graph, Start start, double target) {
  SolveFigures out;
  Options options{.start = start, .threads = 1};
  options.callback = [&](const IterationRecord& record) {
    if (record.chi2 > target) return true;
    out.arrival_s = record.time_s;
    return false;
  };
  graph.push();
  const Report report = optimize(graph, options);
  graph.pop();
  out.chi2 = report.chi2_final;
  out.iterations = report.iterations;
  out.linearize_s = report.time.linearize_s / std::max(1, report.iterations);
  out.iteration_s = median_iteration(report);
  return out;
}

SolveFigures run_ceres(CeresPeer& peer, const CeresSettings& settings, const CeresStop& stop) {
  const CeresRun run = peer.solve(settings, stop);
  return {run.arrival_s, run.jacobian_s, run.iteration_s, static_cast<double>(run.iterations),
          run.chi2_final};
}

/// Runs Ceres with each of all_ceres_settings(). Returns the index of the fastest settings that reach the
/// target. If no settings reach it, returns the index of the settings with the best chi2. Stores the run with
/// these settings in `best`.
std::size_t find_fastest(CeresPeer& peer, const CeresStop& stop, SolveFigures& best) {
  std::size_t fastest = 0;
  const auto rank = [](const SolveFigures& f) { return std::pair(f.arrival_s, f.arrived() ? 0 : f.chi2); };
  for (std::size_t k = 0; k < all_ceres_settings().size(); ++k) {
    SolveFigures run = run_ceres(peer, all_ceres_settings()[k], stop);
    if (run.arrived()) {  // keep the faster of two runs, in case one was disturbed
      run.arrival_s = std::min(run.arrival_s, run_ceres(peer, all_ceres_settings()[k], stop).arrival_s);
    }
    if (k > 0 && rank(run) >= rank(best)) continue;
    best = run;
    fastest = k;
  }
  return fastest;
}

void require_equal(const char* what, double a, double b) {
  if (std::abs(a - b) <= 1e-9 * std::abs(a)) return;
  throw std::runtime_error(fmt::format("{}: expected {:.15g} within 1e-9, got {:.15g}", what, a, b));
}

/// Checks that boxplus and Ceres solve the same problem. At the start, chi2 must be equal in boxplus and
/// Ceres, and Ceres must compute equal gradients with analytic Jacobians and with automatic differentiation.
void check_start(CeresPeer& analytic, CeresPeer& autodiff, double chi2) {
  const CeresStop at_once{.iterations = 0};
  const CeresRun by_hand = analytic.solve(all_ceres_settings()[0], at_once);
  const CeresRun automatic = autodiff.solve(all_ceres_settings()[0], at_once);
  require_equal("chi2 of Ceres's analytic edges at the start", chi2, by_hand.chi2_initial);
  require_equal("chi2 of Ceres's autodiff edges at the start", chi2, automatic.chi2_initial);
  require_equal("largest gradient of Ceres's analytic edges", automatic.gradient_max, by_hand.gradient_max);
}

}  // namespace

SolveComparison run_solve_comparison(Graph& graph, double target) {
  const PlainGraph plain = numbers_of(graph);
  CeresPeer analytic(plain, CeresPeer::Jacobians::kAnalytic),
      autodiff(plain, CeresPeer::Jacobians::kAutodiff);
  SolveComparison comparison;
  comparison.chi2_initial = graph.chi2();
  check_start(analytic, autodiff, comparison.chi2_initial);

  CeresStop stop{.chi2 = target};
  SolveFigures scouted;
  const std::size_t fastest = find_fastest(analytic, stop, scouted);
  const CeresSettings& settings = all_ceres_settings()[fastest];
  comparison.ceres_settings = settings.name;
  comparison.ceres_settings_index = static_cast<int>(fastest);
  if (!scouted.arrived()) stop.iterations = kIterationsWhenStuck;
  const std::vector<Figures> medians =
      interleaved_medians({[&] { return numbers(run_ours(graph, Start::kCurrent, target)); },
                           [&] { return numbers(run_ours(graph, Start::kAutomatic, target)); },
                           [&] { return numbers(run_ceres(analytic, settings, stop)); },
                           [&] { return numbers(run_ceres(autodiff, settings, stop)); }},
                          {.least = 5, .most = 15, .enough_s = 5});
  comparison.ours = figures(medians[0]);
  comparison.ours_automatic = figures(medians[1]);
  comparison.analytic = figures(medians[2]);
  comparison.autodiff = figures(medians[3]);
  if (!scouted.arrived()) {
    for (SolveFigures* ceres : {&comparison.analytic, &comparison.autodiff}) {
      ceres->chi2 = scouted.chi2;
      ceres->iterations = scouted.iterations;
    }
  }
  return comparison;
}

}  // namespace boxplus::bench
