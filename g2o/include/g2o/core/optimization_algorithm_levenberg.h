// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SOLVER_LEVENBERG_H
#define G2O_SOLVER_LEVENBERG_H

#include <memory>

#include "g2o/core/optimization_algorithm_with_hessian.h"

namespace g2o {

/// Levenberg-Marquardt with the damping term λI and Nielsen's rule for λ.
class G2O_CORE_API OptimizationAlgorithmLevenberg : public OptimizationAlgorithmWithHessian {
 public:
  explicit OptimizationAlgorithmLevenberg(std::unique_ptr<Solver> solver);
  /// For clients that pass a raw pointer. The algorithm takes ownership.
  explicit OptimizationAlgorithmLevenberg(Solver* solver);
  ~OptimizationAlgorithmLevenberg() override;

  SolverResult solve(int iteration, bool online = false) override;
  void printVerbose(std::ostream& os) const override;

  double currentLambda() const { return _currentLambda; }
  /// The maximum number of steps that one iteration tries before it returns Terminate.
  void setMaxTrialsAfterFailure(int max_trials);
  int maxTrialsAfterFailure() const { return _maxTrialsAfterFailure->value(); }
  /// The initial λ. If it is ≤ 0, the initial λ is 1e-5 times the largest diagonal entry of H.
  double userLambdaInit() { return _userLambdaInit->value(); }
  void setUserLambdaInit(double lambda);
  /// The number of steps that the last iteration tried.
  int levenbergIteration() { return _levenbergIterations; }

 protected:
  Property<int>* _maxTrialsAfterFailure;  ///< owned by _properties, like the next member
  Property<double>* _userLambdaInit;
  double _currentLambda = -1;
  double _tau = 1e-5;
  double _goodStepLowerScale = 1. / 3;
  double _goodStepUpperScale = 2. / 3;
  double _ni = 2;
  int _levenbergIterations = 0;

  double computeLambdaInit() const;
  /// Returns the predicted decrease of chi2.
  double computeScale() const;
};

}  // namespace g2o

#endif  // G2O_SOLVER_LEVENBERG_H
