// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_DENSE_H
#define G2O_LINEAR_SOLVER_DENSE_H

#include <typeinfo>

#include "g2o/solvers/engine_linear_solver.h"

namespace g2o {

/// Dense Cholesky factorization, for small problems.
template <typename MatrixType>
class LinearSolverDense : public internal::EngineLinearSolver<MatrixType> {
 public:
  LinearSolverDense() : internal::EngineLinearSolver<MatrixType>(internal::EngineSolver::kDense) {}
  /// Returns no settings for a derived class, because the derived class may override solve().
  internal::EngineSettings engine() const override {
    return typeid(*this) == typeid(LinearSolverDense) ? this->settings_ : internal::EngineSettings();
  }
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_DENSE_H
