// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/optimization_algorithm_levenberg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

#include "core/pushed_estimates.h"
#include "core/refused_steps.h"
#include "g2o/core/sparse_optimizer.h"

namespace g2o {
namespace {

/// Let x be the step that solves (H + λI) x = b. Returns the largest decrease of chi2 that the quadratic
/// model predicts for any multiple of x: the maximum of 2αbᵀx − α²xᵀHx over α.
double largest_decrease_along(const Solver& solver, double lambda) {
  const auto n = static_cast<Eigen::Index>(solver.vectorSize());
  const Eigen::Map<const VectorX> x(solver.x(), n), b(solver.b(), n);
  const double slope = b.dot(x), curvature = slope - lambda * x.squaredNorm();
  return curvature > 0 ? slope * slope / curvature : std::numeric_limits<double>::infinity();
}

/// Whether both the predicted and the actual decrease of chi2 are below rounding error. Also requires that
/// the largest decrease that the model predicts along the step is small, because a large λ alone can make the
/// step short.
bool is_below_rounding(double chi2, double predicted, double largest_predicted, double decrease) {
  constexpr double kRounding = 1e-13, kMostShortening = 1000;
  return predicted <= kRounding * chi2 && std::abs(decrease) <= kRounding * chi2 &&
         largest_predicted <= kMostShortening * kRounding * chi2;
}

}  // namespace

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

/// Changes λ as in Nielsen, "Damping parameter in Marquardt's method", 1999. If a step decreases chi2, λ
/// shrinks. The larger the decrease is relative to the predicted decrease, the more λ shrinks. If a step
/// fails, λ is multiplied by ν, and ν doubles.
OptimizationAlgorithm::SolverResult OptimizationAlgorithmLevenberg::solve(int iteration, bool online) {
  if (!linearize(iteration, online)) return Fail;
  const double chi2 = linearizedChi2();
  if (!reportUnlessFinite(std::isfinite(chi2))) return Fail;
  if (iteration == 0) {
    _currentLambda = computeLambdaInit();
    _ni = 2;
  }
  double gain = 0;
  bool finished = false;
  _levenbergIterations = 0;
  do {
    internal::PushedEstimates<SparseOptimizer> pushed(*_optimizer);
    const bool solved = solveDamped(_currentLambda);
    double trial = std::numeric_limits<double>::max();
    if (solved && internal::update(*_optimizer, _solver.x())) {
      trial = computeRobustChi2();
    }
    const double predicted = solved ? computeScale() : 0;
    gain = solved ? (chi2 - trial) / predicted : -1;
    finished = solved && is_below_rounding(chi2, predicted, largest_decrease_along(_solver, _currentLambda),
                                           chi2 - trial);
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
  } while (gain < 0 && !finished && _levenbergIterations < _maxTrialsAfterFailure->value() &&
           !_optimizer->terminate());
  if (G2OBatchStatistics* statistics = G2OBatchStatistics::globalStats())
    statistics->levenbergIterations = _levenbergIterations;
  if (gain > 0) return finished ? Terminate : OK;
  _optimizer->computeActiveErrors();  // the edges still have the errors of the rejected step
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
