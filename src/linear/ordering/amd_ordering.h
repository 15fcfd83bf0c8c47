// SPDX-License-Identifier: BSD-3-Clause
// Fill-reducing order of the blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// The elimination order of the blocks: order[k] is eliminated k-th. Approximate minimum degree (Amestoy,
/// Davis, Duff 1996/2004) of the graph whose nodes are blocks, so that the cost does not depend on the sizes
/// of the blocks.
///
/// The blocks of `last` come at the end, in the given order. The others are ordered as if those did not
/// exist, because their order does not change the fill among the last blocks.
///
/// AMD cannot be interrupted: throws Stopped if it is predicted not to end before the deadline of `stop`.
std::vector<std::uint32_t> amd_ordering(const BlockStructure& structure,
                                        std::span<const std::uint32_t> last = {}, const StopToken& stop = {});

inline constexpr int kIsLast = -1;
/// The number of each block among those that may be ordered freely, or kIsLast. Throws InvalidArgument if
/// `last` repeats a block or names one that does not exist.
std::vector<int> number_free_blocks(const BlockStructure& structure, std::span<const std::uint32_t> last);

/// Constrained approximate minimum degree: blocks of a lower rank (0 … blocks − 1) come before those of a
/// higher one. Within a rank, blocks are ordered by degree, which counts the neighbors of all ranks. `stop`
/// as above.
std::vector<std::uint32_t> constrained_amd_ordering(const BlockStructure& structure, std::span<int> rank_of,
                                                    const StopToken& stop = {});

}  // namespace boxplus
