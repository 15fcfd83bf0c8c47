// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Adds the vertices in the order of their ids, and estimates each from those before it. After every
/// Options::update_every vertices, optimizes for one iteration, or for as many as the options request. Adds
/// the iterations to `run`.
void grow(g2o::SparseOptimizer& optimizer, const Options& options, Run& run);

}  // namespace g2o_tool
