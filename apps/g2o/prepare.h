// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"
#include "options.h"

namespace g2o_tool {

/// Fixes what the options say, and a vertex of its own choice where the graph still floats. False where it
/// names a vertex that is not there.
bool fix_gauge(g2o::SparseOptimizer& optimizer, const Options& options);
void marginalize_landmarks(g2o::SparseOptimizer& optimizer);
/// False where the kernel is unknown.
bool add_robust_kernels(g2o::SparseOptimizer& optimizer, const Options& options);
/// Says how many vertices cannot be reached from the fixed ones.
void warn_about_unconnected(g2o::SparseOptimizer& optimizer);

}  // namespace g2o_tool
