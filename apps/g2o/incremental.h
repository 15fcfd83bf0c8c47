// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "iterate.h"
#include "options.h"

namespace g2o_tool {

/// Adds the vertices in the order of their ids, and estimates each from those before it. Optimizes after
/// every Options::update_every of them: for one iteration, or as the options say. Adds to `run`.
void grow(g2o::SparseOptimizer& optimizer, const Options& options, Run& run);

}  // namespace g2o_tool
