// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"

namespace g2o {
namespace internal {

/// Moves the vertices by ⊞; false if one of them refused its step.
bool update(SparseOptimizer& optimizer, const double* step);

}  // namespace internal
}  // namespace g2o
