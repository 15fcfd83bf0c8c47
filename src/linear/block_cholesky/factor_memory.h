// SPDX-License-Identifier: BSD-3-Clause
// The places of the fronts of a factor in its arena.
#pragma once

#include "base/paced_stop.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Assigns places to panels and update matrices, and sets the sizes of the factor that depend on them. May be
/// called again after fronts have changed. O(fronts), plus the search for holes between update matrices.
void assign_memory(SymbolicFactor& factor, PacedStop& pace);

/// The leading dimension of a panel. Avoids multiples of the page size, because the columns would then
/// compete for the same cache set.
std::uint32_t choose_leading(std::uint32_t rows);

}  // namespace boxplus
