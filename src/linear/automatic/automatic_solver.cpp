// SPDX-License-Identifier: BSD-3-Clause
#include "linear/automatic/automatic_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "platform/memory.h"

namespace boxplus {
namespace {

/// Half of the physical memory, because the graph, H and other programs need the other half.
std::uint64_t default_limit() {
  const std::uint64_t memory = physical_memory();
  return memory > 0 ? memory / 2 : std::numeric_limits<std::uint64_t>::max();
}

/// The predicted time that pcg takes for a rough solution. The number of iterations grows with the diameter
/// of the graph. The cube root of the number of vertices approximates the diameter, because a factor becomes
/// too large only if the graph is roughly three-dimensional. Each iteration reads H twice.
double pcg_seconds(const BlockStructure& structure) {
  constexpr double kIterations = 15, kSecondsPerByte = 2e-10;
  const double bytes = static_cast<double>(structure.nonzero_values()) * sizeof(double);
  return kIterations * std::cbrt(structure.blocks()) * 2 * bytes * kSecondsPerByte;
}

/// A factorization is accepted if it takes at most this many times as long as a rough solution by pcg,
/// because it gives an exact solution, even if H is ill-conditioned.
constexpr double kMaxSlowdown = 4;
constexpr double kShortSeconds = 1;  // a factorization is accepted if its predicted time is below this

}  // namespace

void AutomaticSolver::analyze(const BlockStructure& structure, const AnalyzeHints& hints,
                              const StopToken& stop) {
  const std::uint64_t wanted = options_.automatic.max_factor_bytes;
  const std::uint64_t limit = wanted > 0 ? wanted : default_limit();
  auto fresh = std::make_unique<BlockCholesky>(options_.block_cholesky);
  BlockCholesky& cholesky = *fresh;
  chosen_ = std::move(fresh);  // frees the memory of the last analysis before the new analysis
  pcg_seconds_ = pcg_seconds(structure);
  bool accepted = false;
  const auto accepts = [&](const BlockCholesky::Forecast& forecast) {
    return accepted =
               forecast.bytes <= limit && forecast.seconds <= kMaxSlowdown * pcg_seconds_ + kShortSeconds;
  };
  factor_ = cholesky.analyze_if(accepts, structure, hints, stop);
  refused_ = !accepted;
  if (accepted) return;
  chosen_ = std::make_unique<Pcg>();
  chosen_->analyze(structure, hints, stop);
}

SolveControl AutomaticSolver::control_for_chosen(const SolveControl& control) const {
  SolveControl result = control;
  if (refused_)
    result.relative_tolerance = std::max(control.relative_tolerance, options_.automatic.min_tolerance);
  return result;
}

FactorResult AutomaticSolver::factorize(const BlockSystem& system, const Damping& damping,
                                        const SolveControl& control) {
  return chosen_->factorize(system, damping, control_for_chosen(control));
}

SolveResult AutomaticSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  return chosen_->solve(b, columns, x, control_for_chosen(control));
}

bool AutomaticSolver::selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                                       const StopToken& stop) {
  return chosen_->selected_inverse(blocks, out, stop);
}

LinearStatistics AutomaticSolver::statistics() const {
  LinearStatistics statistics = chosen_->statistics();
  statistics.factor_seconds = factor_.seconds;
  statistics.pcg_seconds = pcg_seconds_;
  statistics.refused_factor_bytes = refused_ ? factor_.bytes : 0;
  return statistics;
}

}  // namespace boxplus
