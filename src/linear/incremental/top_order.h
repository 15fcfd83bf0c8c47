// SPDX-License-Identifier: BSD-3-Clause
// Elimination orders for the top of a tree that grows at its newest block.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// Chooses the order that is predicted to need the fewest operations, of several candidates: by minimum
/// degree; the oldest of those blocks whose degree is at most the minimum plus a slack; and, for large
/// structures, AMD. The blocks of the structure are sorted by age. The last block comes last in every
/// candidate, because the next block is usually connected to it. Returns order[k], the block that is
/// eliminated k-th.
std::vector<std::uint32_t> order_top(const BlockStructure& structure);

}  // namespace boxplus
