// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SOLVER_LEVENBERG_H
#define G2O_SOLVER_LEVENBERG_H

#include <memory>

#include "g2o/core/optimization_algorithm_with_hessian.h"

namespace g2o {

/// Levenberg-Marquardt with λI and Nielsen's rule for λ.
class G2O_CORE_API OptimizationAlgorithmLevenberg : public OptimizationAlgorithmWithHessian {
 public:
  explicit OptimizationAlgorithmLevenberg(std::unique_ptr<Solver> solver);
  /// As clients of old write it; takes ownership.
  explicit OptimizationAlgorithmLevenberg(Solver* solver);
  ~OptimizationAlgorithmLevenberg() override;

  SolverResult solve(int iteration, bool online = false) override;
  void printVerbose(std::ostream& os) const override;

  double currentLambda() const { return _currentLambda; }
  /// How many steps may be tried in one iteration; then the result is Terminate.
  void setMaxTrialsAfterFailure(int max_trials);
  int maxTrialsAfterFailure() const { return _maxTrialsAfterFailure->value(); }
  /// The first λ; ≤ 0: 1e-5 times the largest diagonal entry of H.
  double userLambdaInit() { return _userLambdaInit->value(); }
  void setUserLambdaInit(double lambda);
  /// Steps tried in the last iteration.
  int levenbergIteration() { return _levenbergIterations; }

 protected:
  Property<int>* _maxTrialsAfterFailure;  ///< of _properties, as the one below
  Property<double>* _userLambdaInit;
  double _currentLambda = -1;
  double _tau = 1e-5;
  double _goodStepLowerScale = 1. / 3;
  double _goodStepUpperScale = 2. / 3;
  double _ni = 2;
  int _levenbergIterations = 0;

  double computeLambdaInit() const;
  /// By how much the model says that chi2 falls.
  double computeScale() const;
};

}  // namespace g2o

#endif  // G2O_SOLVER_LEVENBERG_H
