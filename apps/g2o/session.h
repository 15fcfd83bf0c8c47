// SPDX-License-Identifier: BSD-3-Clause
// What the programs that optimize a file do before and after their iterations.
#pragma once

#include <functional>
#include <optional>

#include "g2o/core/optimization_algorithm.h"
#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Prints the lists that the user asked for, constructs the algorithm, loads the graph, fixes its gauge, and
/// adds the robust kernels. Returns the exit code if the program must end, after a message. Otherwise,
/// `algorithm` is the algorithm of the optimizer.
std::optional<int> prepare(g2o::SparseOptimizer& optimizer, const Options& options,
                           g2o::OptimizationAlgorithm*& algorithm);

/// The chi2 of the active edges at the current estimates, with their robust kernels.
double chi2(g2o::SparseOptimizer& optimizer);
/// The chi2 of all edges, whether they are active or not, without kernels.
double chi2_of_all(g2o::SparseOptimizer& optimizer);

/// Calls start(), which may change the estimates, and iterations(), which adds what it did to the result.
/// Prints chi2 after each, and the covariances if the user wants them. If there is nothing to optimize, calls
/// neither. From start() on, interrupts stop the optimizer.
Run optimize(g2o::SparseOptimizer& optimizer, g2o::OptimizationAlgorithm& algorithm, const Options& options,
             const std::function<void()>& start, const std::function<void(Run&)>& iterations);

}  // namespace g2o_tool
