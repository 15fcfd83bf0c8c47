// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/core/sparse_optimizer_terminate_action.h"

#include "g2o/core/sparse_optimizer.h"

namespace g2o {

SparseOptimizerTerminateAction::SparseOptimizerTerminateAction() = default;

HyperGraphAction* SparseOptimizerTerminateAction::operator()(const HyperGraph* graph,
                                                             Parameters* parameters) {
  const auto* const_optimizer = dynamic_cast<const SparseOptimizer*>(graph);
  const auto* iteration = dynamic_cast<const ParametersIteration*>(parameters);
  if (const_optimizer == nullptr || iteration == nullptr) return nullptr;
  auto* optimizer = const_cast<SparseOptimizer*>(const_optimizer);
  if (iteration->iteration < 0) {
    setOptimizerStopFlag(optimizer, false);
    return this;
  }
  optimizer->computeActiveErrors();
  const double chi2 = optimizer->activeRobustChi2();
  if (iteration->iteration > 0) {
    const double gain = (_lastChi - chi2) / chi2;
    const bool converged = (gain >= 0 && gain < _gainThreshold) || chi2 == 0;
    if (converged || iteration->iteration >= _maxIterations) setOptimizerStopFlag(optimizer, true);
  }
  _lastChi = chi2;
  return this;
}

void SparseOptimizerTerminateAction::setGainThreshold(double gainThreshold) {
  _gainThreshold = gainThreshold;
}

void SparseOptimizerTerminateAction::setMaxIterations(int maxit) {
  _maxIterations = maxit;
}

/// Sets the value of the client's stop flag. If the client set no flag, sets the value of the optimizer's
/// internal flag.
void SparseOptimizerTerminateAction::setOptimizerStopFlag(const SparseOptimizer* optimizer, bool stop) {
  auto* stopped = const_cast<SparseOptimizer*>(optimizer);
  if (stopped->forceStopFlag() == nullptr) stopped->setForceStopFlag(&stopped->own_stop_flag_);
  *stopped->forceStopFlag() = stop;
  _auxTerminateFlag = stop;
}

}  // namespace g2o
