// SPDX-License-Identifier: BSD-3-Clause
// Where the fronts of a factor lie in its arena.
#pragma once

#include "base/paced_stop.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Lays out panels and update matrices; sets the sizes of the factor that follow. May be called again after
/// fronts have changed. O(fronts), but for holes between update matrices.
void assign_memory(SymbolicFactor& factor, PacedStop& pace);

/// The leading dimension of a panel: columns far apart by a multiple of the page size would fall into the
/// same cache set.
std::uint32_t choose_leading(std::uint32_t rows);

}  // namespace boxplus
