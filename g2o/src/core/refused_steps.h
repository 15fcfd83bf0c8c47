// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"

namespace g2o {
namespace internal {

/// Moves the vertices by ⊞. Returns false if a vertex refused its step.
bool update(SparseOptimizer& optimizer, const double* step);

}  // namespace internal
}  // namespace g2o
