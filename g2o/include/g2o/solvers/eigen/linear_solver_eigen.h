// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_EIGEN_H
#define G2O_LINEAR_SOLVER_EIGEN_H

#include <typeinfo>

#include "g2o/solvers/engine_linear_solver.h"

namespace g2o {

/// Sparse Cholesky factorization. By default, uses the engine's implementation, which orders blocks. After
/// setBlockOrdering(false), uses Eigen's implementation, which orders scalars.
template <typename MatrixType>
class LinearSolverEigen : public internal::EngineLinearSolver<MatrixType> {
 public:
  LinearSolverEigen() : internal::EngineLinearSolver<MatrixType>(internal::EngineSolver::kCholesky) {}
  /// If `exact` is true, always factorizes in double precision. Otherwise, if Solver::inexactSteps() is true,
  /// factorizes large fronts in single precision and refines steps until their residual is 1e-6 of the
  /// right-hand side. g2o does not have this function.
  void setExact(bool exact) { this->settings_.exact = exact; }
  /// The engine does not replace a derived class, because the class may solve in a different way.
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
