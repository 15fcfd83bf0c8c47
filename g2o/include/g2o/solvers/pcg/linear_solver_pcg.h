// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_PCG_H
#define G2O_LINEAR_SOLVER_PCG_H

#include <typeinfo>

#include "g2o/solvers/engine_linear_solver.h"

namespace g2o {

/// Preconditioned conjugate gradients.
template <typename MatrixType>
class LinearSolverPCG : public internal::EngineLinearSolver<MatrixType> {
 public:
  LinearSolverPCG() : internal::EngineLinearSolver<MatrixType>(internal::EngineSolver::kPcg) {
    this->settings_.tolerance = _tolerance;
    this->settings_.absoluteTolerance = _absoluteTolerance;
  }
  /// Returns no settings for a derived class, because the derived class may override solve().
  internal::EngineSettings engine() const override {
    return typeid(*this) == typeid(LinearSolverPCG) ? this->settings_ : internal::EngineSettings();
  }
  /// The solver stops when the residual is below this tolerance, relative to the residual of x = 0.
  double tolerance() const { return _tolerance; }
  void setTolerance(double tolerance) {
    _tolerance = tolerance;
    this->settings_.tolerance = tolerance;
  }
  /// The iteration limit. If it is not positive, the limit is twice the number of scalars, but at least 100.
  int maxIterations() const { return _maxIter; }
  void setMaxIterations(int maxIter) {
    _maxIter = maxIter;
    this->settings_.maxIterations = maxIter > 0 ? maxIter : 0;
  }
  /// If true, the solver also stops when the absolute residual is below tolerance(). This saves iterations
  /// near the minimum of chi2, because the right-hand side is almost zero there.
  bool absoluteTolerance() const { return _absoluteTolerance; }
  void setAbsoluteTolerance(bool absoluteTolerance) {
    _absoluteTolerance = absoluteTolerance;
    this->settings_.absoluteTolerance = absoluteTolerance;
  }
  bool verbose() const { return _verbose; }
  void setVerbose(bool verbose) { _verbose = verbose; }

 protected:
  double _tolerance = 1e-6;
  bool _verbose = false;
  bool _absoluteTolerance = true;
  int _maxIter = -1;
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_PCG_H
