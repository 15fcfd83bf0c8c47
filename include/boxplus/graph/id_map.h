// SPDX-License-Identifier: BSD-3-Clause
// A map from ids to vertices.
#pragma once

#include <cstddef>
#include <vector>

#include "boxplus/graph/handle.h"

namespace boxplus::detail {

/// A hash table in one block of memory. Consecutive ids are neighbors in memory, so the vertices of an edge
/// are found quickly: their ids are usually close to each other. If an entry is taken, the search continues
/// with a stride that depends on the hash of the id, so that no pattern of ids makes the search slow. find(),
/// insert() and erase() are O(1) on average over the ids. The cost of growth is amortized.
class IdMap {
 public:
  std::size_t size() const { return size_; }
  bool contains(Id id) const { return find(id) != nullptr; }
  /// The vertex with that id, or nullptr if there is none. Valid until the next change.
  const VertexRef* find(Id id) const;
  /// After this call, the next insert() does not allocate.
  void make_room();
  /// The id must be ≥ 0 and new.
  void insert(Id id, VertexRef vertex);
  /// The id must be in the map.
  void erase(Id id);
  /// All vertices in the order of their ids. O(n log n).
  std::vector<VertexRef> by_id() const;

 private:
  static constexpr Id kFree = -1, kErased = -2;  // an erased entry does not end a search
  struct Entry {
    Id id = kFree;
    VertexRef vertex;
  };

  std::size_t place_of(Id id) const;

  std::vector<Entry> entries_;  // 2^k entries; at least a quarter of them are free
  std::size_t size_ = 0, used_ = 0;
};

}  // namespace boxplus::detail
