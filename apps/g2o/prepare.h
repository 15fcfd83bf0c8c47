// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// Fixes the vertices that the options name. If there is still gauge freedom, fixes one more vertex. Returns
/// false if the options name a vertex that does not exist.
bool fix_gauge(g2o::SparseOptimizer& optimizer, const Options& options);
void marginalize_landmarks(g2o::SparseOptimizer& optimizer);
/// Returns false if the kernel is unknown.
bool add_robust_kernels(g2o::SparseOptimizer& optimizer, const Options& options);
/// If some vertices are not connected to a fixed vertex, prints a warning with the number of these vertices.
void warn_about_unconnected(g2o::SparseOptimizer& optimizer);

}  // namespace g2o_tool
