// SPDX-License-Identifier: BSD-3-Clause
#include "datasets/linear_comparison.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "base/stopwatch.h"
#include "boxplus/linear/make_linear_solver.h"
#include "datasets/cholmod_peer.h"
#include "datasets/interleave.h"
#include "linearize/linearizer.h"

namespace boxplus::bench {
namespace {

/// The limit of the relative difference of two solutions. For the worst conditioned H of the data sets, the
/// solutions of different solvers differ by about 1e-7.
constexpr double kSameSolution = 1e-5;

template <class F>
double seconds_of(F&& action) {
  const Stopwatch clock;
  action();
  return clock.seconds();
}

/// The linear system of a graph at its estimates: H and −g.
struct Equations {
  explicit Equations(const Graph& graph) : plan(make_plan(graph, {})), linearizer(graph, plan) {
    linearizer.linearize({});
    for (const double g : linearizer.gradient()) right_hand_side.push_back(-g);
  }
  Plan plan;
  Linearizer linearizer;
  std::vector<double> right_hand_side;
};

/// Measures a new solver of boxplus, and stores it in `last`. The solver of the previous repetition is
/// destroyed before the measurement begins; run_cholmod() frees its previous factor, too.
Figures run_ours(const Equations& equations, Precision precision, std::unique_ptr<LinearSolver>& last,
                 std::vector<double>& x) {
  const auto make = [&](Ordering ordering) {
    return make_linear_solver(LinearSolverKind::kBlockCholesky,
                              {.block_cholesky = {.ordering = ordering, .precision = precision}});
  };
  last = make(Ordering::kMinimumDegree);
  const AssembledSystem system(equations.plan.structure, equations.linearizer.values());
  const double by_degree = seconds_of([&] { last->analyze(equations.plan.structure, {}); });
  last = make(Ordering::kAutomatic);
  LinearSolver& solver = *last;
  const double analyze = seconds_of([&] { solver.analyze(equations.plan.structure, {}); });
  const auto factorize = [&] {
    if (solver.factorize(system, {}).status != LinearStatus::kOk) {
      throw std::runtime_error("our factorization failed");
    }
  };
  const auto solve = [&] { solver.solve(equations.right_hand_side.data(), 1, x.data()); };
  factorize();  // not measured, because it touches new memory; run_cholmod() does the same
  return {analyze, seconds_of(factorize), seconds_of(solve), by_degree};
}

Figures run_cholmod(const Equations& equations, CholmodPeer& peer, std::vector<double>& x) {
  peer.forget();
  const double analyze = seconds_of([&] { peer.analyze(); });
  peer.factorize();
  const double factorize = seconds_of([&] { peer.factorize(); });
  const double solve = seconds_of([&] { peer.solve(equations.right_hand_side); });
  const auto solution = peer.solve(equations.right_hand_side);
  x.assign(solution.begin(), solution.end());
  return {analyze, factorize, solve};
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0, size = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    size = std::max(size, std::abs(a[i]));
  }
  return difference / size;
}

/// Returns the time of CHOLMOD's analysis with AMD: simplicial or supernodal, whichever factorizes faster.
double amd_analysis(const std::vector<Figures>& medians, bool on_blocks) {
  const Figures* best = nullptr;
  for (std::size_t k = 0; k < medians.size(); ++k) {
    const CholmodSettings& settings = all_cholmod_settings()[k];
    if (settings.ordering != CholmodSettings::Ordering::kAmd || settings.on_blocks != on_blocks) continue;
    if (best == nullptr || medians[k][1] < (*best)[1]) best = &medians[k];
  }
  return (*best)[0];
}

}  // namespace

LinearComparison run_linear_comparison(Graph& graph) {
  const Equations equations(graph);
  std::unique_ptr<LinearSolver> in_double, automatic;
  std::vector<double> our_x(equations.right_hand_side.size()), automatic_x = our_x;
  std::vector<std::unique_ptr<CholmodPeer>> peers;
  std::vector<Contestant> contestants{
      [&] { return run_ours(equations, Precision::kDouble, in_double, our_x); },
      [&] { return run_ours(equations, Precision::kAutomatic, automatic, automatic_x); }};
  LinearComparison comparison;
  std::vector<std::vector<double>> peer_x(all_cholmod_settings().size());
  for (const CholmodSettings& settings : all_cholmod_settings()) {
    peers.push_back(
        std::make_unique<CholmodPeer>(equations.plan.structure, equations.linearizer.values(), settings));
    contestants.emplace_back([&, peer = peers.back().get(), &x = peer_x[peers.size() - 1]] {
      return run_cholmod(equations, *peer, x);
    });
  }
  std::vector<Figures> medians = interleaved_medians(contestants, {.least = 5, .most = 25, .enough_s = 2});
  const Figures ours = medians[0], chosen = medians[1];
  medians.erase(medians.begin(), medians.begin() + 2);
  const auto best = std::min_element(medians.begin(), medians.end(),
                                     [](const Figures& a, const Figures& b) { return a[1] < b[1]; });
  const CholmodPeer& best_peer = *peers[static_cast<std::size_t>(best - medians.begin())];
  comparison.scalars = equations.plan.scalars();
  comparison.analyze_by_degree_s = ours[3];
  comparison.dissected = in_double->statistics().ordering == Ordering::kNestedDissection;
  comparison.mixed = automatic->statistics().precision == Precision::kMixed;
  const double flops = in_double->statistics().factor_flops;
  comparison.ours = {ours[0], ours[1], ours[2], flops};
  comparison.automatic =
      comparison.mixed ? LinearFigures{chosen[0], chosen[1], chosen[2], flops} : comparison.ours;
  comparison.cholmod = {(*best)[0], (*best)[1], (*best)[2], best_peer.flops()};
  comparison.cholmod_settings = best_peer.settings().name();
  comparison.cholmod_amd_analyze_s = amd_analysis(medians, false);
  comparison.cholmod_block_amd_analyze_s = amd_analysis(medians, true);
  for (const std::vector<double>& x : peer_x) {
    comparison.largest_difference = std::max(
        {comparison.largest_difference, relative_difference(our_x, x), relative_difference(automatic_x, x)});
  }
  if (!(comparison.largest_difference < kSameSolution))
    throw std::runtime_error("the solutions of CHOLMOD differ from ours");
  return comparison;
}

}  // namespace boxplus::bench
