// SPDX-License-Identifier: BSD-3-Clause
// Assigns addresses in one arena to buffers whose lifetimes are known in advance.
#pragma once

#include <cstdint>
#include <vector>

namespace boxplus {

/// Simulates first-fit allocation once, when the structure is analyzed. Every factorization then uses the
/// same addresses. Buffers that live at the same time never overlap.
class MemoryPlan {
 public:
  /// Reserves `size` free values until release(). Returns their address.
  std::uint64_t reserve(std::uint64_t size);
  void release(std::uint64_t address, std::uint64_t size);
  /// The number of values that the arena must hold.
  std::uint64_t peak() const { return end_; }

 private:
  struct Hole {
    std::uint64_t address, size;
    std::uint64_t end() const { return address + size; }
  };
  /// Sorted by address. Two holes are never adjacent. There are so few holes that a vector is faster than a
  /// tree.
  std::vector<Hole> holes_;
  std::uint64_t end_ = 0;
};

}  // namespace boxplus
