// SPDX-License-Identifier: BSD-3-Clause
#include "core/refused_steps.h"

#include "g2o/core/refused_step.h"
#include "g2o/stuff/logger.h"

namespace g2o {
namespace internal {
namespace {

/// Whether a vertex refused its step in the current update() of this thread.
bool& is_refused() {
  thread_local bool refused = false;
  return refused;
}

}  // namespace

void refuseStep(const OptimizableGraph::Vertex& v) {
  if (!is_refused()) G2O_WARN("vertex {}: a step leads to an estimate that is not finite", v.id());
  is_refused() = true;
}

bool update(SparseOptimizer& optimizer, const double* step) {
  is_refused() = false;
  optimizer.update(step);
  return !is_refused();
}

}  // namespace internal
}  // namespace g2o
