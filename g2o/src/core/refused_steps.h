// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/sparse_optimizer.h"

namespace g2o {
namespace internal {

/// Calls optimizer.update(step). Returns false if a vertex refused its part of the step, because the new
/// estimate would not be finite.
bool update(SparseOptimizer& optimizer, const double* step);

}  // namespace internal
}  // namespace g2o
