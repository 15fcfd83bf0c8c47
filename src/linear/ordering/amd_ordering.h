// SPDX-License-Identifier: BSD-3-Clause
// A fill-reducing order of the blocks.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// What AMD does with blocks that have more than 10 √n neighbors, of n blocks.
enum class DenseRows : std::uint8_t {
  kLast,  ///< puts them last, without ordering them; much faster if only a few blocks of a large graph are so
  kOrdered  ///< orders them like all others
};

/// The elimination order of the blocks: order[k] is the block that is eliminated k-th. Uses approximate
/// minimum degree (AMD; Amestoy, Davis, Duff 1996/2004) on the graph whose nodes are the blocks, so that the
/// time does not depend on the sizes of the blocks.
///
/// The blocks of `last` come at the end, in the given order. All other blocks are ordered as if the blocks of
/// `last` did not exist, because this does not change the fill among the blocks of `last`.
///
/// Because AMD cannot be interrupted, this function throws Stopped if AMD is predicted to end after the
/// deadline of `stop`.
std::vector<std::uint32_t> amd_ordering(const BlockStructure& structure,
                                        std::span<const std::uint32_t> last = {}, const StopToken& stop = {},
                                        DenseRows dense_rows = DenseRows::kLast);

inline constexpr int kIsLast = -1;
/// Numbers the blocks that may be ordered freely. The blocks of `last` get kIsLast instead of a number.
/// Throws InvalidArgument if `last` repeats a block or names a block that does not exist.
std::vector<int> number_free_blocks(const BlockStructure& structure, std::span<const std::uint32_t> last);

/// Constrained approximate minimum degree (CAMD): blocks of a lower rank (0 … blocks − 1) come before blocks
/// of a higher rank. Blocks of the same rank are ordered by degree, which counts the neighbors of all ranks.
/// `stop` works as in amd_ordering().
std::vector<std::uint32_t> constrained_amd_ordering(const BlockStructure& structure, std::span<int> rank_of,
                                                    const StopToken& stop = {});

}  // namespace boxplus
