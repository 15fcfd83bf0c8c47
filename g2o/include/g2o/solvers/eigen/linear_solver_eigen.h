// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_EIGEN_H
#define G2O_LINEAR_SOLVER_EIGEN_H

#include <typeinfo>

#include "g2o/solvers/engine_linear_solver.h"

namespace g2o {

/// Sparse Cholesky factorization. By default, uses the implementation of the engine (the library boxplus),
/// with a fill-reducing ordering of blocks. After setBlockOrdering(false), uses the implementation of Eigen,
/// with an ordering of scalars.
template <typename MatrixType>
class LinearSolverEigen : public internal::EngineLinearSolver<MatrixType> {
 public:
  LinearSolverEigen() : internal::EngineLinearSolver<MatrixType>(internal::EngineSolver::kCholesky) {}
  /// If `exact` is true, always factorizes in double precision. Otherwise, if Solver::inexactSteps() is true,
  /// factorizes large fronts in single precision, and refines each step until the norm of its residual is at
  /// most 1e-6 times the norm of the right-hand side. g2o does not have this function.
  void setExact(bool exact) { this->settings_.exact = exact; }
  /// Returns no settings for a derived class, because the derived class may override solve().
  internal::EngineSettings engine() const override {
    return typeid(*this) == typeid(LinearSolverEigen) ? this->settings() : internal::EngineSettings();
  }
  bool solveBlocks(double**& blocks, const SparseBlockMatrix<MatrixType>& A) override {
    return this->inverseBlocks(blocks, A);
  }
  bool solvePattern(SparseBlockMatrix<MatrixX>& spinv, const std::vector<std::pair<int, int>>& blockIndices,
                    const SparseBlockMatrix<MatrixType>& A) override {
    return this->inversePattern(spinv, blockIndices, A);
  }
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_EIGEN_H
