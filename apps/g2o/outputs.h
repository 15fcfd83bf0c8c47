// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Writes all outputs that the options request. If a file cannot be written, prints a message and returns
/// false.
bool write_outputs(const g2o::SparseOptimizer& optimizer, const Options& options, const Run& run);
/// Writes gnuplot commands that draw the active edges to standard output.
void stream_gnuplot(const g2o::SparseOptimizer& optimizer);
/// Prints the diagonal blocks of the covariance matrix at the current estimates, and the blocks next to the
/// diagonal.
void print_marginals(g2o::SparseOptimizer& optimizer, g2o::OptimizationAlgorithm& algorithm);

}  // namespace g2o_tool
