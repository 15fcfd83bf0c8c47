// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H
#define G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H

#include <limits>

#include "g2o/core/hyper_graph_action.h"

namespace g2o {

class SparseOptimizer;

/// A post-iteration action that ends optimize() once chi2 falls by less than a fraction of itself, or after
/// so many iterations.
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
  bool _auxTerminateFlag = false;  ///< what setOptimizerStopFlag() was last given
  int _maxIterations = std::numeric_limits<int>::max();

  void setOptimizerStopFlag(const SparseOptimizer* optimizer, bool stop);
};

}  // namespace g2o

#endif  // G2O_SPARSE_OPTIMIZER_TERMINATE_ACTION_H
