// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPTIMIZATION_ALGORITHM_GAUSS_NEWTON_H
#define G2O_OPTIMIZATION_ALGORITHM_GAUSS_NEWTON_H

#include <memory>

#include "g2o/core/optimization_algorithm_with_hessian.h"

namespace g2o {

/// Accepts every Gauss-Newton step. If H is not positive definite, keeps the estimates and returns Fail.
class G2O_CORE_API OptimizationAlgorithmGaussNewton : public OptimizationAlgorithmWithHessian {
 public:
  explicit OptimizationAlgorithmGaussNewton(std::unique_ptr<Solver> solver);
  /// For clients that pass a raw pointer. The algorithm takes ownership.
  explicit OptimizationAlgorithmGaussNewton(Solver* solver);
  ~OptimizationAlgorithmGaussNewton() override;

  SolverResult solve(int iteration, bool online = false) override;
  void printVerbose(std::ostream& os) const override;
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_GAUSS_NEWTON_H
