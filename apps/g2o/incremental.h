// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// Adds the vertices in the order of their ids, each estimated from those before it, and optimises after
/// every Options::update_every of them: one iteration, or as many as were asked for. Returns how many there
/// were.
int grow(g2o::SparseOptimizer& optimizer, const Options& options);

}  // namespace g2o_tool
