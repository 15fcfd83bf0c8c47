// SPDX-License-Identifier: BSD-3-Clause
// Fill-reducing order of the blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// Elimination order of the blocks: order[k] is eliminated k-th. Approximate minimum degree (Amestoy, Davis,
/// Duff 1996/2004) of the graph whose nodes are blocks, so that its cost does not depend on the blocks'
/// sizes.
///
/// The blocks of `last` come at the end, in the given order; the others are ordered as if those did not exist
/// (their fill among the last blocks does not depend on the order of the others).
///
/// AMD cannot be interrupted: throws Stopped if it is predicted not to end before the deadline of `stop`.
std::vector<std::uint32_t> amd_ordering(const BlockStructure& structure,
                                        std::span<const std::uint32_t> last = {}, const StopToken& stop = {});

inline constexpr int kIsLast = -1;
/// Number of each block among those that may be ordered freely, kIsLast for the others. Throws
/// InvalidArgument where `last` repeats a block or names one that there is not.
std::vector<int> number_free_blocks(const BlockStructure& structure, std::span<const std::uint32_t> last);

/// Constrained approximate minimum degree: blocks of a lower rank (0 … blocks − 1) before those of a higher
/// one, and within a rank by degree, counting the neighbors of all ranks. `stop` as above.
std::vector<std::uint32_t> constrained_amd_ordering(const BlockStructure& structure, std::span<int> rank_of,
                                                    const StopToken& stop = {});

}  // namespace boxplus
