// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/memory_plan.h"

#include <iterator>

namespace boxplus {

std::uint64_t MemoryPlan::reserve(std::uint64_t size) {
  if (size == 0) return 0;
  for (auto hole = free_.begin(); hole != free_.end(); ++hole) {
    const auto [address, space] = *hole;
    const bool grows = address + space == end_;  // the last hole may be extended
    if (space < size && !grows) continue;
    free_.erase(hole);
    if (space > size) free_.emplace(address + size, space - size);
    if (space < size) end_ = address + size;
    return address;
  }
  const std::uint64_t address = end_;
  end_ += size;
  return address;
}

void MemoryPlan::release(std::uint64_t address, std::uint64_t size) {
  if (size == 0) return;
  auto next = free_.lower_bound(address);
  if (next != free_.end() && address + size == next->first) {
    size += next->second;
    next = free_.erase(next);
  }
  if (next != free_.begin()) {
    const auto previous = std::prev(next);
    if (previous->first + previous->second == address) {
      previous->second += size;
      return;
    }
  }
  free_.emplace(address, size);
}

}  // namespace boxplus
