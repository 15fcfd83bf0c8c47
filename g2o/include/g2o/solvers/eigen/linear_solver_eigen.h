// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_EIGEN_H
#define G2O_LINEAR_SOLVER_EIGEN_H

#include <typeinfo>

#include "g2o/solvers/engine_linear_solver.h"

namespace g2o {

/// Sparse Cholesky: the engine's, which orders blocks; without setBlockOrdering(), Eigen's, which orders
/// scalars.
template <typename MatrixType>
class LinearSolverEigen : public internal::EngineLinearSolver<MatrixType> {
 public:
  LinearSolverEigen() : internal::EngineLinearSolver<MatrixType>(internal::EngineSolver::kCholesky) {}
  /// Factorises in double always (not in g2o). By default, where Solver::inexactSteps(), large fronts are
  /// factorised in float, and steps refined until their residual is 1e-6 of the right-hand side.
  void setExact(bool exact) { this->settings_.exact = exact; }
  /// Not in the place of a derived class, which may solve otherwise.
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
