// SPDX-License-Identifier: BSD-3-Clause
#include "linear/automatic/automatic_solver.h"

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

void AutomaticSolver::analyze(const BlockStructure& structure, const AnalyzeHints& hints) {
  const std::uint64_t limit = hints.max_factor_bytes > 0 ? hints.max_factor_bytes : default_limit();
  auto fresh = std::make_unique<BlockCholesky>();
  BlockCholesky& cholesky = *fresh;
  chosen_ = std::move(fresh);  // gives back the memory of the last analysis first
  cholesky.set_stop(stop());
  pcg_seconds_ = pcg_seconds(structure);
  bool accepted = false;
  const auto accepts = [&](const BlockCholesky::Forecast& forecast) {
    return accepted = forecast.bytes <= limit && forecast.seconds <= kWorth * pcg_seconds_ + kShort;
  };
  factor_ = cholesky.analyze_if(accepts, structure, hints);
  refused_ = !accepted;
  if (accepted) return;
  chosen_ = std::make_unique<Pcg>();
  chosen_->set_stop(stop());
  chosen_->analyze(structure, hints);
}

FactorResult AutomaticSolver::factorize(const BlockSystem& system, const Damping& damping,
                                        std::span<const std::uint32_t> changed_columns) {
  chosen_->set_stop(stop());
  return chosen_->factorize(system, damping, changed_columns);
}

SolveResult AutomaticSolver::solve(const double* b, int columns, double* x, const SolveControl& control) {
  chosen_->set_stop(stop());
  return chosen_->solve(b, columns, x, control);
}

bool AutomaticSolver::selected_inverse(std::span<const BlockCoordinate> blocks, double* out) {
  chosen_->set_stop(stop());
  return chosen_->selected_inverse(blocks, out);
}

LinearStatistics AutomaticSolver::statistics() const {
  LinearStatistics statistics = chosen_->statistics();
  statistics.factor_seconds = factor_.seconds;
  statistics.pcg_seconds = pcg_seconds_;
  statistics.refused_factor_bytes = refused_ ? factor_.bytes : 0;
  return statistics;
}

}  // namespace boxplus
