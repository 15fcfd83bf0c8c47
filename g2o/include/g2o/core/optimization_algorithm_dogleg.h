// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_OPTIMIZATION_ALGORITHM_DOGLEG_H
#define G2O_OPTIMIZATION_ALGORITHM_DOGLEG_H

#include <memory>

#include "g2o/core/block_solver.h"
#include "g2o/core/optimization_algorithm_with_hessian.h"

namespace g2o {

/// Powell's dogleg method.
class G2O_CORE_API OptimizationAlgorithmDogleg : public OptimizationAlgorithmWithHessian {
 public:
  enum { STEP_UNDEFINED, STEP_SD, STEP_GN, STEP_DL };

  explicit OptimizationAlgorithmDogleg(std::unique_ptr<BlockSolverBase> solver);
  /// For clients that pass a raw pointer. The algorithm takes ownership.
  explicit OptimizationAlgorithmDogleg(BlockSolverBase* solver);
  ~OptimizationAlgorithmDogleg() override;

  /// Logs an error and returns false if a property has an invalid value.
  bool init(bool online = false) override;
  SolverResult solve(int iteration, bool online = false) override;
  void printVerbose(std::ostream& os) const override;

  int lastStep() const { return _lastStep; }
  double trustRegion() const { return _delta; }
  static const char* stepType2Str(int stepType);

 protected:
  Property<int>* _maxTrialsAfterFailure;  ///< owned by _properties, like the next three members
  Property<double>* _userDeltaInit;
  Property<double>* _initialLambda;
  Property<double>* _lamdbaFactor;

  VectorX _hsd;        ///< steepest descent step
  VectorX _hdl;        ///< dogleg step
  VectorX _auxVector;  ///< scratch memory
  double _currentLambda = 0;
  double _delta = 1e4;  ///< trust-region radius
  bool _wasPDInAllIterations = true;
  int _lastStep = STEP_UNDEFINED;
  int _lastNumTries = 0;

 private:
  bool solveGaussNewton();
  void findSteepestDescent();
  void blend(const VectorX& gaussNewton);

  BlockSolverBase& block_solver_;
};

}  // namespace g2o

#endif  // G2O_OPTIMIZATION_ALGORITHM_DOGLEG_H
