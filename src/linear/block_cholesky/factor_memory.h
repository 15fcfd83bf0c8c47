// SPDX-License-Identifier: BSD-3-Clause
// The memory layout of a factor. All panels and update matrices of its fronts are in one arena.
#pragma once

#include "base/paced_stop.h"
#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {

/// Assigns addresses in the arena to the panels and the update matrices, and sets the members of the factor
/// that depend on the sizes of the fronts. Takes O(fronts) time, plus the time to search for free memory
/// between update matrices.
void assign_memory(SymbolicFactor& factor, PacedStop& pace);

/// The leading dimension of a panel with this many rows. Avoids multiples of 64, because the entries of a row
/// would then compete for the same cache sets.
std::uint32_t choose_leading(std::uint32_t rows);

}  // namespace boxplus
