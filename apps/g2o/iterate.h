// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// The results of a run: chi2 at three times, and the numbers of iterations and failures.
struct Run {
  double chi2_loaded = 0, chi2_initial = 0, chi2_final = 0;
  int iterations = 0, failures = 0;
  std::vector<g2o::G2OBatchStatistics> statistics;
};

/// Lets interrupts (SIGINT) stop the optimizer. The first two interrupts ask the optimizer to stop. The third
/// interrupt ends the program.
void stop_at_interrupts(g2o::SparseOptimizer& optimizer);

/// Optimizes the initialized graph for `iterations` iterations. If `iterations` is negative, optimizes until
/// the gain is small. Adds the results to `run`.
void iterate(g2o::SparseOptimizer& optimizer, const Options& options, int iterations, Run& run);

}  // namespace g2o_tool
