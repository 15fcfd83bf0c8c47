// SPDX-License-Identifier: BSD-3-Clause
// A linear solver for symmetric systems that may be indefinite.
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <memory>
#include <utility>

#include "boxplus/linear/linear_solver.h"

namespace g2o {
namespace internal {

/// Forwards all calls to `cholesky`. If the matrix is not positive definite, factorizes it by LU with
/// pivoting instead. So it also solves the systems of equality constraints with Lagrange multipliers, which
/// have positive and negative pivots. If the matrix is singular, returns the result of `cholesky`.
class PivotingSolver final : public boxplus::LinearSolver {
 public:
  explicit PivotingSolver(std::unique_ptr<boxplus::LinearSolver> cholesky) : cholesky_(std::move(cholesky)) {}

  std::string_view name() const override { return cholesky_->name(); }
  Needs needs() const override { return Needs::kBlocks; }
  void analyze(const boxplus::BlockStructure& structure, const boxplus::AnalyzeHints& hints,
               const boxplus::StopToken& stop) override;
  boxplus::FactorResult factorize(const boxplus::BlockSystem& system, const boxplus::Damping& damping,
                                  const boxplus::SolveControl& control) override;
  boxplus::SolveResult solve(const double* b, int columns, double* x,
                             const boxplus::SolveControl& control) override;
  bool selected_inverse(std::span<const boxplus::BlockCoordinate> blocks, double* out,
                        const boxplus::StopToken& stop) override;
  boxplus::LinearStatistics statistics() const override { return cholesky_->statistics(); }

 private:
  void load(const boxplus::BlockSystem& system, const boxplus::Damping& damping);
  void scale();
  bool factorize_scaled();

  std::unique_ptr<boxplus::LinearSolver> cholesky_;
  const boxplus::BlockStructure* structure_ = nullptr;
  Eigen::SparseMatrix<double> matrix_;  // S (A + λD) S, both triangles
  Eigen::VectorXd scale_;               // the diagonal of S
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
  boxplus::FactorResult cholesky_result_;
  bool has_pattern_ = false;  // true if `lu_` knows the pattern of the structure
};

}  // namespace internal
}  // namespace g2o
