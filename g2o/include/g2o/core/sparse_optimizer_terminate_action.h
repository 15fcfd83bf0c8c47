// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H
#define G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H

#include <limits>

#include "g2o/core/hyper_graph_action.h"

namespace g2o {

class SparseOptimizer;

/// A post-iteration action that stops optimize() when chi2 decreases by less than a given fraction, or after
/// a given number of iterations.
class G2O_CORE_API SparseOptimizerTerminateAction : public HyperGraphAction {
 public:
  SparseOptimizerTerminateAction();
  HyperGraphAction* operator()(const HyperGraph* graph, Parameters* parameters = nullptr) override;

  double gainThreshold() const { return _gainThreshold; }
  void setGainThreshold(double gainThreshold);
  int maxIterations() const { return _maxIterations; }
  void setMaxIterations(int maxit);

 protected:
  double _gainThreshold = 1e-6;
  double _lastChi = 0;
  bool _auxTerminateFlag = false;  ///< the last value passed to setOptimizerStopFlag()
  int _maxIterations = std::numeric_limits<int>::max();

  void setOptimizerStopFlag(const SparseOptimizer* optimizer, bool stop);
};

}  // namespace g2o

#endif  // G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H
