// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "g2o/core/sparse_optimizer.h"

namespace g2o_tool {

struct EngineStartOptions {
  int iterations = 100;       ///< at most
  std::string robust_kernel;  ///< of all edges; empty: none
  double robust_kernel_width = -1;
  bool print_report = false;
};

/// Replaces the estimates of the initialized graph by those that the engine of boxplus finds, if their chi2
/// is lower. The engine takes the current estimates or its chordal guess, a linear solution for all poses and
/// landmarks together, and iterates from there. It leaves out the types that it does not know (those of
/// plug-ins). Prints what it did to standard error.
void start_with_engine(g2o::SparseOptimizer& optimizer, const EngineStartOptions& options);

}  // namespace g2o_tool
