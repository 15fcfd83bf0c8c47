// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Writes all outputs of the options. False, with a message, if one of the files cannot be written.
bool write_outputs(const g2o::SparseOptimizer& optimizer, const Options& options, const Run& run);
/// Writes commands for gnuplot, which draw the active edges, to standard output.
void stream_gnuplot(const g2o::SparseOptimizer& optimizer);
/// Prints the diagonal blocks of the covariance at the estimates, and the neighboring blocks.
void print_marginals(g2o::SparseOptimizer& optimizer, g2o::OptimizationAlgorithm& algorithm);

}  // namespace g2o_tool
