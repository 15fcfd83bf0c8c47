// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Adds the vertices to the optimization in the order of their ids. Initializes the estimate of each vertex
/// from vertices that were added earlier. After every Options::update_every vertices, optimizes for
/// Options::iterations iterations, or for one iteration if the user requested no number. Adds the iterations
/// to `run`.
void grow(g2o::SparseOptimizer& optimizer, const Options& options, Run& run);

}  // namespace g2o_tool
