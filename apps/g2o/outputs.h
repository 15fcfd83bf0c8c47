// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// What a line of the summary tells.
struct Run {
  double chi2_loaded = 0, chi2_initial = 0, chi2_final = 0;
  int iterations = 0;
};

/// False, with a message, where a file cannot be written.
bool write_outputs(g2o::SparseOptimizer& optimizer, const Options& options, const Run& run);
/// Writes commands for gnuplot that draw the active edges to the standard output.
void stream_gnuplot(const g2o::SparseOptimizer& optimizer);
/// Prints the diagonal blocks of the covariance, and those beside them.
void print_marginals(g2o::SparseOptimizer& optimizer);

}  // namespace g2o_tool
