// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/memory_plan.h"

#include <algorithm>

namespace boxplus {

std::uint64_t MemoryPlan::reserve(std::uint64_t size) {
  if (size == 0) return 0;
  for (auto hole = holes_.begin(); hole != holes_.end(); ++hole) {
    const std::uint64_t address = hole->address;
    const bool grows = hole->end() == end_;  // a hole at the end can be enlarged
    if (hole->size < size && !grows) continue;
    if (hole->size > size) {
      *hole = {address + size, hole->size - size};
    } else {
      end_ = std::max(end_, address + size);
      holes_.erase(hole);
    }
    return address;
  }
  const std::uint64_t address = end_;
  end_ += size;
  return address;
}

void MemoryPlan::release(std::uint64_t address, std::uint64_t size) {
  if (size == 0) return;
  auto next = std::partition_point(holes_.begin(), holes_.end(),
                                   [address](const Hole& hole) { return hole.address < address; });
  const bool joins_next = next != holes_.end() && address + size == next->address;
  const bool joins_previous = next != holes_.begin() && next[-1].end() == address;
  if (joins_previous) {
    next[-1].size += size + (joins_next ? next->size : 0);
    if (joins_next) holes_.erase(next);
  } else if (joins_next) {
    *next = {address, size + next->size};
  } else {
    holes_.insert(next, {address, size});
  }
}

}  // namespace boxplus
