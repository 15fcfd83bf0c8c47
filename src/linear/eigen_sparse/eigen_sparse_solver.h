// SPDX-License-Identifier: BSD-3-Clause
// Eigen's simplicial Cholesky as a LinearSolver, to check the other solvers and as a baseline for benchmarks.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// Deviates from the contract of LinearSolver: Eigen's factorize() and solve() allocate temporaries on every
/// call.
///
/// Eigen reports that a pivot was ≤ 0, but not which one. To name the block, the matrix is factorized once
/// more by BlockCholesky. Its elimination order differs, so it may name another one of several bad blocks.
/// Pivots that lost their digits without becoming ≤ 0 are found and named in Eigen's order (see kLostPivot).
class EigenSparseSolver final : public LinearSolver {
 public:
  std::string_view name() const override { return "eigen_sparse"; }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  bool selected_inverse(std::span<const BlockCoordinate> blocks, double* out,
                        const StopToken& stop = {}) override;
  LinearStatistics statistics() const override;

 private:
  using Sparse = Eigen::SparseMatrix<double>;

  void load(const BlockSystem& system, const Damping& damping);
  std::uint32_t find_lost_pivot();
  FactorResult explain_failure(const BlockSystem& system, const Damping& damping,
                               const SolveControl& control) const;

  const BlockStructure* structure_ = nullptr;
  Sparse matrix_;  // lower triangle
  Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
  Eigen::VectorXd diagonal_, direction_, solution_;
  bool factorized_ = false;
};

}  // namespace boxplus
