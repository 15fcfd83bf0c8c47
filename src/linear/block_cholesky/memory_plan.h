// SPDX-License-Identifier: BSD-3-Clause
// Addresses in one arena for buffers whose lifetimes are known in advance.
#pragma once

#include <cstdint>
#include <vector>

namespace boxplus {

/// Simulates first-fit allocation once, when the structure is analyzed. Every factorization then uses the
/// same addresses. Buffers that live at the same time never overlap.
class MemoryPlan {
 public:
  /// The address of `size` free values, reserved until release().
  std::uint64_t reserve(std::uint64_t size);
  void release(std::uint64_t address, std::uint64_t size);
  /// The number of values that the arena must have.
  std::uint64_t peak() const { return end_; }

 private:
  struct Hole {
    std::uint64_t address, size;
    std::uint64_t end() const { return address + size; }
  };
  std::vector<Hole> holes_;  // by address, never adjacent; few, so that moving them is cheaper than a tree
  std::uint64_t end_ = 0;
};

}  // namespace boxplus
