// SPDX-License-Identifier: BSD-3-Clause
#include "linear/automatic/automatic_solver.h"

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

}  // namespace

void AutomaticSolver::analyze(const BlockStructure& structure, const AnalyzeHints& hints) {
  const std::uint64_t limit = hints.max_factor_bytes > 0 ? hints.max_factor_bytes : default_limit();
  auto fresh = std::make_unique<BlockCholesky>();
  BlockCholesky& cholesky = *fresh;
  chosen_ = std::move(fresh);  // gives back the memory of the last analysis first
  const std::uint64_t bytes = cholesky.analyze_within(limit, structure, hints);
  refused_factor_bytes_ = bytes > limit ? bytes : 0;
  if (refused_factor_bytes_ == 0) return;
  chosen_ = std::make_unique<Pcg>();
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
  statistics.refused_factor_bytes = refused_factor_bytes_;
  return statistics;
}

}  // namespace boxplus
