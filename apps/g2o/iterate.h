// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// What happened.
struct Run {
  double chi2_loaded = 0, chi2_initial = 0, chi2_final = 0;
  int iterations = 0, failures = 0;
  std::vector<g2o::G2OBatchStatistics> statistics;
};

/// Lets interrupts stop the optimiser: the first two ask for the end, the third ends the program.
void stop_at_interrupts(g2o::SparseOptimizer& optimizer);

/// Optimises what was initialised, for so many iterations, or, where they are negative, until the gain is
/// small. Adds to `run`.
void iterate(g2o::SparseOptimizer& optimizer, const Options& options, int iterations, Run& run);

}  // namespace g2o_tool
