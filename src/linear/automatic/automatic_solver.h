// SPDX-License-Identifier: BSD-3-Clause
// Uses the direct solver if its factor fits into memory and the factorization does not take too long.
// Otherwise, uses the iterative solver.
#pragma once

#include "linear/block_cholesky/block_cholesky.h"
#include "linear/pcg/pcg.h"

namespace boxplus {

/// analyze() predicts the cost of the factor and chooses the solver before it allocates memory for the
/// factor. From then on, name() returns the name of the chosen solver, and statistics() contains the reason
/// for the choice.
class AutomaticSolver final : public LinearSolver {
 public:
  /// Of `options`, only those of the automatic solver and of the block Cholesky matter.
  explicit AutomaticSolver(const LinearSolverOptions& options = {}) : options_(options) {}

  std::string_view name() const override { return chosen_->name(); }
  /// Both solvers have the same needs.
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  bool selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                        const StopToken& stop = {}) override;
  LinearStatistics statistics() const override;
  std::span<const std::uint32_t> elimination_order() const override { return chosen_->elimination_order(); }

 private:
  SolveControl control_for_chosen(const SolveControl& control) const;

  LinearSolverOptions options_;
  std::unique_ptr<LinearSolver> chosen_ = std::make_unique<BlockCholesky>();
  BlockCholesky::Forecast factor_;
  double pcg_seconds_ = 0;
  bool refused_ = false;
};

}  // namespace boxplus
