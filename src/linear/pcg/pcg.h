// SPDX-License-Identifier: BSD-3-Clause
// Conjugate gradients, preconditioned with the Cholesky factors of the damped diagonal blocks.
#pragma once

#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "linear/conjugate_gradients.h"

namespace boxplus {

/// If a system has no values, calls only its multiply() and block_diagonal(). factorize() copies the damping
/// and keeps a reference to the system, which must live until the last solve(). If a diagonal block is not
/// positive definite, the result of factorize() names the block. If solve() finds a direction of curvature ≤
/// 0, it returns kNotPositiveDefinite. If solve() does not return kOk, x holds the last iterate.
class Pcg final : public LinearSolver {
 public:
  std::string_view name() const override { return "pcg"; }
  Needs needs() const override { return Needs::kOperator; }
  void analyze(const BlockStructure& structure, const AnalyzeHints& hints,
               const StopToken& stop = {}) override;
  FactorResult factorize(const BlockSystem& system, const Damping& damping,
                         const SolveControl& control = {}) override;
  SolveResult solve(const double* b, int columns, double* x, const SolveControl& control = {}) override;
  LinearStatistics statistics() const override;

 private:
  void multiply(const double* x, double* y) const;
  void precondition(const double* r, double* z) const;

  const BlockStructure* structure_ = nullptr;
  const BlockSystem* system_ = nullptr;
  std::vector<double> preconditioner_;  // the Cholesky factors of the damped diagonal blocks
  std::vector<double> damping_, minimum_pivot_;
  ConjugateGradients iteration_;
};

}  // namespace boxplus
