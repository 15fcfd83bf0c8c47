// SPDX-License-Identifier: BSD-3-Clause
// A LinearSolver that eliminates blocks by the Schur complement, and solves for the remaining blocks with
// another solver.
#pragma once

#include <memory>
#include <vector>

#include "boxplus/linear/make_linear_solver.h"
#include "linear/schur/column_elimination.h"
#include "linear/schur/schur.h"

namespace boxplus {

/// Eliminates the first AnalyzeHints::eliminated_blocks blocks, and lets `inner` solve for the remaining
/// blocks. Returns the name and the statistics of `inner`. If the hints ask to eliminate no blocks or all
/// blocks, `inner` solves for all blocks.
class SchurSolver final : public LinearSolver, public ColumnElimination {
 public:
  /// `inner` must not be null.
  SchurSolver(std::shared_ptr<LinearSolver> inner, SchurMode mode, KeptBlocks kept)
      : inner_(std::move(inner)), mode_(mode), kept_(kept) {}

  std::string_view name() const override { return inner_->name(); }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;

  /// Schur::leave_out() for scalars of H; those of eliminated blocks must be left out of H. Call it after
  /// analyze().
  void leave_out(std::span<const std::uint32_t> scalars) {
    if (eliminates()) schur_->leave_out(scalars);
  }
  int slices() const override { return eliminates() && !reduced_->values().empty() ? schur_->slices() : 0; }
  void begin(const Damping& damping, const SolveControl& control) override {
    schur_->begin(damping, control.right_hand_side);
  }
  void eliminate_columns(int slice, std::uint32_t first, std::uint32_t last, const double* values,
                         const StopToken& stop) override {
    schur_->eliminate_columns(slice, first, last, values, stop);
  }
  FactorResult finish(std::span<const double> values, const Damping& damping,
                      const SolveControl& control) override;
  SolveResult solve_kept(double* x, const SolveControl& control) override;
  void solve_eliminated(std::uint32_t block, double* x) const override { schur_->solve_eliminated(block, x); }

  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  /// Works for all blocks of H, if the inner solver can compute blocks of the inverse of the Schur
  /// complement.
  bool selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                        const StopToken& stop = {}) override;
  LinearStatistics statistics() const override { return inner_->statistics(); }
  /// The order of the inner solver; empty if blocks are eliminated.
  std::span<const std::uint32_t> elimination_order() const override {
    return eliminates() ? std::span<const std::uint32_t>() : inner_->elimination_order();
  }

 private:
  bool eliminates() const { return schur_ != nullptr; }
  SolveResult solve_batch(const double* b, int columns, double* x, const SolveControl& control);
  FactorResult factorize_reduced(std::span<const double> values, const Damping& damping,
                                 const SolveControl& control);
  SolveResult solve_reduced(int columns, const SolveControl& control);
  void move_to_full_numbering(std::uint32_t& block, std::uint32_t& scalar) const;

  std::shared_ptr<LinearSolver> inner_;
  SchurMode mode_;
  KeptBlocks kept_;
  const BlockStructure* structure_ = nullptr;
  std::unique_ptr<Schur> schur_;
  std::unique_ptr<BlockSystem> reduced_;
  std::vector<double> reduced_vectors_;  // right-hand sides of the reduced system, and then their solutions
  int batch_ = 1;                        // the number of vectors that fit in reduced_vectors_
  bool factorized_ = false;
  /// The right-hand side that factorize() has reduced to the first column of reduced_vectors_, or null.
  const double* reduced_for_ = nullptr;
};

}  // namespace boxplus
