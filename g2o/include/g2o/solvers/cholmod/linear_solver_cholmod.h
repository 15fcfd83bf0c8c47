// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_CHOLMOD
#define G2O_LINEAR_SOLVER_CHOLMOD

#include <string>
#include <typeinfo>

#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace g2o {

/// The same solver as LinearSolverEigen, under the name that clients of CHOLMOD use. It does not need CHOLMOD
/// or any other third-party library. The algorithms of the library solver_cholmod (gn_var_cholmod, …) use it.
///
/// As in CHOLMOD, the matrix may be indefinite, for example if Lagrange multipliers of equality constraints
/// are vertices.
template <typename MatrixType>
class LinearSolverCholmod : public LinearSolverEigen<MatrixType> {
 public:
  LinearSolverCholmod() { this->settings_.indefinite = true; }
  internal::EngineSettings engine() const override {
    return typeid(*this) == typeid(LinearSolverCholmod) ? this->settings() : internal::EngineSettings();
  }
  /// Writes the matrix of the last solve() for Octave. Returns false if there is no such matrix. If the
  /// solver belongs to a BlockSolver, use Solver::saveHessian() instead.
  virtual bool saveMatrix(const std::string& fileName) { return this->engine_.save(fileName); }
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_CHOLMOD
