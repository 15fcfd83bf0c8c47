// SPDX-License-Identifier: BSD-3-Clause
// Eigen's simplicial Cholesky as a LinearSolver. Tests compare the other solvers with it, and benchmarks use
// it as a baseline.
#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// Deviates from the contract of LinearSolver: Eigen's factorize() and solve() allocate temporaries on every
/// call.
///
/// Eigen reports that a pivot was ≤ 0, but not which one. To find its block, BlockCholesky factorizes the
/// matrix again. Its elimination order differs from Eigen's, so if several blocks are bad, it may name a
/// different one. A pivot that lost its digits but is still > 0 is found in Eigen's order (see kLostPivot).
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
  Sparse matrix_;  // the lower triangle of A + λD
  Eigen::SimplicialLLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
  Eigen::VectorXd diagonal_, direction_, solution_;
  bool factorized_ = false;
};

}  // namespace boxplus
