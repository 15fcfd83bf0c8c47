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
std::vector<std::uint32_t> amd_ordering(const BlockStructure& structure,
                                        std::span<const std::uint32_t> last = {});

}  // namespace boxplus
