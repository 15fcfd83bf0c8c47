// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINEAR_SOLVER_CSPARSE_H
#define G2O_LINEAR_SOLVER_CSPARSE_H

#include <typeinfo>

#include "g2o/solvers/eigen/linear_solver_eigen.h"

namespace g2o {

/// The same solver as LinearSolverEigen, under the name that clients of CSparse use. It does not need CSparse
/// or any other third-party library. The algorithms of the library solver_csparse (gn_var_csparse, …) use it.
template <typename MatrixType>
class LinearSolverCSparse : public LinearSolverEigen<MatrixType> {
 public:
  internal::EngineSettings engine() const override {
    return typeid(*this) == typeid(LinearSolverCSparse) ? this->settings() : internal::EngineSettings();
  }
};

}  // namespace g2o

#endif  // G2O_LINEAR_SOLVER_CSPARSE_H
