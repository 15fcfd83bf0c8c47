// SPDX-License-Identifier: BSD-3-Clause
// A fill-reducing order of the blocks for factors with large fronts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// The elimination order of the blocks by nested dissection (George 1973). A separator comes after the parts
/// that it separates. Parts below a few hundred blocks are ordered by approximate minimum degree. This takes
/// several times as long as amd_ordering(), but the factorization needs fewer operations if the graph is
/// neither small nor nearly planar. `last` and `stop` work as in amd_ordering(). The order does not depend on
/// the number of threads.
std::vector<std::uint32_t> nested_dissection(const BlockStructure& structure,
                                             std::span<const std::uint32_t> last = {}, int threads = 1,
                                             const StopToken& stop = {});

}  // namespace boxplus
