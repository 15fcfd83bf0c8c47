// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_levenberg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/pushed_estimates.h"
#include "g2o/core/sparse_optimizer.h"

namespace g2o {

OptimizationAlgorithmLevenberg::OptimizationAlgorithmLevenberg(std::unique_ptr<Solver> solver)
    : OptimizationAlgorithmWithHessian(solver.release()),
      _maxTrialsAfterFailure(_properties.makeProperty<Property<int>>("maxTrialsAfterFailure", 10)),
      _userLambdaInit(_properties.makeProperty<Property<double>>("initialLambda", 0.)) {
  _solver.setLevenberg(true);
  _solver.setInexactSteps(true);
}

OptimizationAlgorithmLevenberg::OptimizationAlgorithmLevenberg(Solver* solver)
    : OptimizationAlgorithmLevenberg(std::unique_ptr<Solver>(solver)) {}

OptimizationAlgorithmLevenberg::~OptimizationAlgorithmLevenberg() = default;

/// Nielsen, "Damping parameter in Marquardt's method", 1999: λ shrinks by how well the model foretold chi2,
/// and grows by ν, which doubles with each failure.
OptimizationAlgorithm::SolverResult OptimizationAlgorithmLevenberg::solve(int iteration, bool online) {
  if (!linearize(iteration, online)) return Fail;
  const double chi2 = _optimizer->activeRobustChi2();
  if (!blameUnless(std::isfinite(chi2))) return Fail;
  if (iteration == 0) {
    _currentLambda = computeLambdaInit();
    _ni = 2;
  }
  double gain = 0;
  _levenbergIterations = 0;
  do {
    internal::PushedEstimates<SparseOptimizer> pushed(*_optimizer);
    const bool solved = solveDamped(_currentLambda);
    double trial = std::numeric_limits<double>::max();
    if (solved) {
      _optimizer->update(_solver.x());
      _optimizer->computeActiveErrors();
      trial = _optimizer->activeRobustChi2();
    }
    gain = solved ? (chi2 - trial) / computeScale() : -1;
    ++_levenbergIterations;
    if (gain > 0 && std::isfinite(trial)) {
      const double shrink = 1 - std::pow(2 * gain - 1, 3);
      _currentLambda *= std::max(_goodStepLowerScale, std::min(_goodStepUpperScale, shrink));
      _ni = 2;
      pushed.keep();
    } else {
      if (!std::isfinite(trial)) gain = -1;
      _currentLambda *= _ni;
      _ni *= 2;
      pushed.restore();
      if (!std::isfinite(_currentLambda)) break;
    }
  } while (gain < 0 && _levenbergIterations < _maxTrialsAfterFailure->value() && !_optimizer->terminate());
  if (G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats())
    statistics->levenbergIterations = _levenbergIterations;
  if (gain > 0) return OK;
  _optimizer->computeActiveErrors();  // those of the rejected step stand in the edges
  return Terminate;
}

double OptimizationAlgorithmLevenberg::computeLambdaInit() const {
  if (_userLambdaInit->value() > 0) return _userLambdaInit->value();
  double largest = 0;
  for (OptimizableGraph::Vertex* v : _optimizer->indexMapping()) {
    for (int i = 0; i < v->dimension(); ++i) largest = std::max(largest, std::abs(v->hessian(i, i)));
  }
  return _tau * largest;
}

double OptimizationAlgorithmLevenberg::computeScale() const {
  constexpr double kNoDivisionByZero = 1e-300;
  double scale = 0;
  for (size_t i = 0; i < _solver.vectorSize(); ++i)
    scale += _solver.x()[i] * (_currentLambda * _solver.x()[i] + _solver.b()[i]);
  return scale + kNoDivisionByZero;
}

void OptimizationAlgorithmLevenberg::setMaxTrialsAfterFailure(int max_trials) {
  _maxTrialsAfterFailure->setValue(max_trials);
}

void OptimizationAlgorithmLevenberg::setUserLambdaInit(double lambda) {
  _userLambdaInit->setValue(lambda);
}

void OptimizationAlgorithmLevenberg::printVerbose(std::ostream& os) const {
  os << "\t schur= " << _solver.schur() << "\t lambda= " << currentLambda()
     << "\t levenbergIter= " << _levenbergIterations;
}

}  // namespace g2o
