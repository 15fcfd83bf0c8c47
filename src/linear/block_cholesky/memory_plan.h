// SPDX-License-Identifier: BSD-3-Clause
// Addresses in one arena for buffers whose lifetimes are known beforehand.
#pragma once

#include <cstdint>
#include <vector>

namespace boxplus {

/// First-fit allocation played through once, when the structure is analyzed: the addresses are then used in
/// every factorization. Buffers that live at the same time never overlap.
class MemoryPlan {
 public:
  /// Address of `size` free numbers, from here until release().
  std::uint64_t reserve(std::uint64_t size);
  void release(std::uint64_t address, std::uint64_t size);
  /// Numbers that the arena must have.
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
