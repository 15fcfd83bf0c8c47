// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// Counts and chi2 of a run.
struct Run {
  double chi2_loaded = 0, chi2_initial = 0, chi2_final = 0;
  int iterations = 0, failures = 0;
  std::vector<g2o::G2OBatchStatistics> statistics;
};

/// Lets interrupts stop the optimizer: the first two request the end, the third ends the program.
void stop_at_interrupts(g2o::SparseOptimizer& optimizer);

/// Optimizes the initialized graph for Options::iterations iterations or, if they are negative, until the
/// gain is small. Adds to `run`.
void iterate(g2o::SparseOptimizer& optimizer, const Options& options, int iterations, Run& run);

}  // namespace g2o_tool
