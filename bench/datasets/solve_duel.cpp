// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/solve_duel.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "boxplus/optimize/optimize.h"
#include "datasets/ceres/ceres_peer.h"
#include "datasets/graph_numbers.h"
#include "datasets/interleave.h"

namespace boxplus::bench {
namespace {

/// Runs that end far from the target are repeated with so few iterations, for the time of one.
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
  if (seconds.size() > 1) seconds.erase(seconds.begin());  // touches fresh memory
  return seconds.empty() ? 0 : median(seconds);
}

/// Optimises from the estimates as they are, and leaves them so.
SolveFigures run_ours(Graph& graph, Start start, double target) {
  SolveFigures out;
  Options options{.start = start, .threads = 1};
  options.callback = [&](const IterationRecord& record) {
    if (record.chi2 > target) return true;
    out.arrival_s = record.time_s;
    return false;
  };
  graph.push();
  graph.cache().reset();
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

/// One run with each of the settings; the index of the fastest that arrives, or of the best chi2.
std::size_t find_fastest(CeresPeer& peer, const CeresStop& stop, SolveFigures& best) {
  std::size_t fastest = 0;
  const auto rank = [](const SolveFigures& f) { return std::pair(f.arrival_s, f.arrived() ? 0 : f.chi2); };
  for (std::size_t k = 0; k < all_ceres_settings().size(); ++k) {
    const SolveFigures run = run_ceres(peer, all_ceres_settings()[k], stop);
    if (k > 0 && rank(run) >= rank(best)) continue;
    best = run;
    fastest = k;
  }
  return fastest;
}

double check_start(CeresPeer& peer, double chi2) {
  const double theirs = peer.solve(all_ceres_settings()[0], {.iterations = 0}).chi2_initial;
  const double difference = std::abs(theirs - chi2) / chi2;
  if (difference <= 1e-9) return difference;
  throw std::runtime_error(fmt::format("chi2 at the start: ours {:.15g}, Ceres's {:.15g}", chi2, theirs));
}

}  // namespace

SolveDuel run_solve_duel(Graph& graph, double target) {
  const PlainGraph plain = numbers_of(graph);
  CeresPeer analytic(plain, CeresPeer::Jacobians::kAnalytic),
      autodiff(plain, CeresPeer::Jacobians::kAutodiff);
  SolveDuel duel;
  duel.chi2_initial = graph.chi2();
  duel.start_difference =
      std::max(check_start(analytic, duel.chi2_initial), check_start(autodiff, duel.chi2_initial));

  CeresStop stop{.chi2 = target};
  SolveFigures scouted;
  const std::size_t fastest = find_fastest(analytic, stop, scouted);
  const CeresSettings& settings = all_ceres_settings()[fastest];
  duel.ceres_settings = settings.name;
  duel.ceres_settings_index = static_cast<int>(fastest);
  if (!scouted.arrived()) stop.iterations = kIterationsWhenStuck;
  const std::vector<Figures> medians =
      interleaved_medians({[&] { return numbers(run_ours(graph, Start::kCurrent, target)); },
                           [&] { return numbers(run_ours(graph, Start::kAutomatic, target)); },
                           [&] { return numbers(run_ceres(analytic, settings, stop)); },
                           [&] { return numbers(run_ceres(autodiff, settings, stop)); }},
                          {.least = 5, .most = 15, .enough_s = 5});
  duel.ours = figures(medians[0]);
  duel.ours_automatic = figures(medians[1]);
  duel.analytic = figures(medians[2]);
  duel.autodiff = figures(medians[3]);
  if (!scouted.arrived()) {
    for (SolveFigures* ceres : {&duel.analytic, &duel.autodiff}) {
      ceres->chi2 = scouted.chi2;
      ceres->iterations = scouted.iterations;
    }
  }
  return duel;
}

}  // namespace boxplus::bench
