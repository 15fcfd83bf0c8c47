// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/symbolic_factor.h"

#include <algorithm>

namespace boxplus {

std::uint32_t SymbolicFactor::row_in(const Front& front, std::uint32_t at) const {
  if (at < front.end_block) return offset[at] - offset[front.first_block];
  const auto all = rows(front);
  const auto found = std::lower_bound(all.begin(), all.end(), at);
  if (found == all.end() || *found != at) return kNoParent;
  return row_offsets[front.row_begin + static_cast<std::size_t>(found - all.begin())];
}

}  // namespace boxplus
