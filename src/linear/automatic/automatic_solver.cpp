// SPDX-License-Identifier: BSD-3-Clause
#include "linear/automatic/automatic_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linear/automatic/physical_memory.h"

namespace boxplus {
namespace {

/// Half of the memory: the rest holds the graph, H and other programs.
std::uint64_t default_limit() {
  const std::uint64_t memory = physical_memory();
  return memory > 0 ? memory / 2 : std::numeric_limits<std::uint64_t>::max();
}

/// Seconds of a rough solution by pcg. Its iterations grow with the diameter of the graph, for which the cube
/// root of its size stands: that of three dimensions, where factors grow out of bounds. Each reads H twice.
double pcg_seconds(const BlockStructure& structure) {
  constexpr double kIterations = 15, kSecondsPerByte = 2e-10;
  const double bytes = static_cast<double>(structure.nonzero_values()) * sizeof(double);
  return kIterations * std::cbrt(structure.blocks()) * 2 * bytes * kSecondsPerByte;
}

/// A factor is worth this many times the rough solution by pcg: it is exact, whatever the condition of H.
constexpr double kWorth = 4;
constexpr double kShort = 1;  // seconds that are not worth a thought

}  // namespace

void AutomaticSolver::analyze(const BlockStructure& structure, const AnalyzeHints& hints,
                              const StopToken& stop) {
  const std::uint64_t wanted = options_.automatic.max_factor_bytes;
  const std::uint64_t limit = wanted > 0 ? wanted : default_limit();
  auto fresh = std::make_unique<BlockCholesky>(options_.block_cholesky);
  BlockCholesky& cholesky = *fresh;
  chosen_ = std::move(fresh);  // gives back the memory of the last analysis first
  pcg_seconds_ = pcg_seconds(structure);
  bool accepted = false;
  const auto accepts = [&](const BlockCholesky::Forecast& forecast) {
    return accepted = forecast.bytes <= limit && forecast.seconds <= kWorth * pcg_seconds_ + kShort;
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
