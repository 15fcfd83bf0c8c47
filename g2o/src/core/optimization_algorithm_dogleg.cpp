// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_dogleg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/pushed_estimates.h"
#include "core/refused_steps.h"
#include "g2o/core/sparse_optimizer.h"
#include "g2o/stuff/logger.h"

namespace g2o {

OptimizationAlgorithmDogleg::OptimizationAlgorithmDogleg(std::unique_ptr<BlockSolverBase> solver)
    : OptimizationAlgorithmWithHessian(solver.release()),
      _maxTrialsAfterFailure(_properties.makeProperty<Property<int>>("maxTrialsAfterFailure", 100)),
      _userDeltaInit(_properties.makeProperty<Property<double>>("initialDelta", 1e4)),
      _initialLambda(_properties.makeProperty<Property<double>>("initialLambda", 1e-7)),
      _lamdbaFactor(_properties.makeProperty<Property<double>>("lambdaFactor", 10.)),
      block_solver_(static_cast<BlockSolverBase&>(_solver)) {
  _solver.setInexactSteps(true);
}

OptimizationAlgorithmDogleg::OptimizationAlgorithmDogleg(BlockSolverBase* solver)
    : OptimizationAlgorithmDogleg(std::unique_ptr<BlockSolverBase>(solver)) {}

OptimizationAlgorithmDogleg::~OptimizationAlgorithmDogleg() = default;

bool OptimizationAlgorithmDogleg::init(bool online) {
  if (_userDeltaInit->value() > 0 && _initialLambda->value() > 0 && _lamdbaFactor->value() > 1)
    return OptimizationAlgorithmWithHessian::init(online);
  G2O_ERROR(
      "dogleg: expected initialDelta and initialLambda above 0 and lambdaFactor above 1, got {}, {} and {}",
      _userDeltaInit->value(), _initialLambda->value(), _lamdbaFactor->value());
  return false;
}

/// Computes the Gauss-Newton step. If H is not positive definite, solves with H + λI instead, and increases λ
/// until H + λI is positive definite.
bool OptimizationAlgorithmDogleg::solveGaussNewton() {
  constexpr double kLargestLambda = 1e3;
  bool solved = false;
  if (_wasPDInAllIterations) _currentLambda = _initialLambda->value();
  do {
    solved = _wasPDInAllIterations ? solveSystem() : solveDamped(_currentLambda);
    if (!_wasPDInAllIterations) {
      const double factor = _lamdbaFactor->value();
      _currentLambda = solved ? std::max(1e-12, _currentLambda / (0.5 * factor)) : _currentLambda * factor;
    }
    _wasPDInAllIterations = _wasPDInAllIterations && solved;
  } while (!solved && _currentLambda <= kLargestLambda);
  return solved;
}

/// Computes the minimum of the quadratic model along b, the direction of steepest descent.
void OptimizationAlgorithmDogleg::findSteepestDescent() {
  const auto n = static_cast<Eigen::Index>(_solver.vectorSize());
  const Eigen::Map<const VectorX> b(_solver.b(), n);
  _auxVector.resize(n);
  block_solver_.multiplyHessian(_auxVector.data(), _solver.b());
  const double curvature = b.dot(_auxVector);
  const double alpha = curvature > 0 ? b.squaredNorm() / curvature : 1;
  _hsd = alpha * b;
}

/// Computes the point on the dogleg path at distance delta. If the path is shorter, computes its end, the
/// Gauss-Newton step.
void OptimizationAlgorithmDogleg::blend(const VectorX& gaussNewton) {
  const double steepest = _hsd.norm();
  if (gaussNewton.norm() < _delta) {
    _hdl = gaussNewton;
    _lastStep = STEP_GN;
  } else if (steepest > _delta) {
    _hdl = _delta / steepest * _hsd;
    _lastStep = STEP_SD;
  } else {
    // The root β in [0, 1] of ‖hsd + β (hgn − hsd)‖ = delta, computed without cancellation.
    const VectorX difference = gaussNewton - _hsd;
    const double a = difference.squaredNorm(), c = _hsd.dot(difference);
    const double rest = _delta * _delta - steepest * steepest;
    const double root = std::sqrt(c * c + a * rest);
    const double beta = c > 0 ? rest / (c + root) : a > 0 ? (root - c) / a : 0;
    _hdl = _hsd + beta * difference;
    _lastStep = STEP_DL;
  }
}

OptimizationAlgorithm::SolverResult OptimizationAlgorithmDogleg::solve(int iteration, bool online) {
  if (!linearize(iteration, online)) return Fail;
  const auto n = static_cast<Eigen::Index>(_solver.vectorSize());
  if (iteration == 0) {
    _currentLambda = _initialLambda->value();
    _delta = _userDeltaInit->value();
    _wasPDInAllIterations = true;
  }
  const double chi2 = linearizedChi2();
  if (!reportUnlessFinite(std::isfinite(chi2))) return Fail;
  findSteepestDescent();
  if (!solveGaussNewton()) return Fail;
  const VectorX gaussNewton = Eigen::Map<const VectorX>(_solver.x(), n);
  const Eigen::Map<const VectorX> b(_solver.b(), n);
  for (_lastNumTries = 1; _lastNumTries <= _maxTrialsAfterFailure->value(); ++_lastNumTries) {
    blend(gaussNewton);
    block_solver_.multiplyHessian(_auxVector.data(), _hdl.data());
    const double predicted = 2 * b.dot(_hdl) - _hdl.dot(_auxVector);
    internal::PushedEstimates<SparseOptimizer> pushed(*_optimizer);
    double trial = std::numeric_limits<double>::infinity();
    if (internal::update(*_optimizer, _hdl.data())) {
      trial = computeRobustChi2();
    }
    const double gain = (chi2 - trial) / predicted;
    const bool good = gain > 0 && std::isfinite(trial);
    if (good) {
      pushed.keep();
    } else {
      pushed.restore();
    }
    if (gain > 0.75) {
      _delta = std::max(_delta, 3 * _hdl.norm());
    } else if (!(gain >= 0.25)) {
      _delta *= 0.5;
    }
    if (good) return OK;
    if (_optimizer->terminate()) break;
  }
  _optimizer->computeActiveErrors();  // the edges still have the errors of the rejected step
  return Terminate;
}

void OptimizationAlgorithmDogleg::printVerbose(std::ostream& os) const {
  os << "\t Delta= " << _delta << "\t step= " << stepType2Str(_lastStep) << "\t tries= " << _lastNumTries;
  if (!_wasPDInAllIterations) os << "\t lambda= " << _currentLambda;
}

const char* OptimizationAlgorithmDogleg::stepType2Str(int stepType) {
  switch (stepType) {
    case STEP_SD:
      return "Descent";
    case STEP_GN:
      return "GN";
    case STEP_DL:
      return "Dogleg";
    default:
      return "Undefined";
  }
}

}  // namespace g2o
