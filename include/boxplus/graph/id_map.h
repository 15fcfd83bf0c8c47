// SPDX-License-Identifier: BSD-3-Clause
// Which vertex has which id.
#pragma once

#include <cstddef>
#include <vector>

#include "boxplus/graph/handle.h"

namespace boxplus {

/// A hash table in one piece of memory, made for ids that count up from a number: such ids lie side by side,
/// as the vertices of an edge mostly do. Where an entry is taken, a stride that the id's hash gives leads to
/// the next, so that no pattern of ids makes it slow. All calls O(1), on average over the ids; growth
/// amortised.
class IdMap {
 public:
  std::size_t size() const { return size_; }
  bool contains(Id id) const { return find(id) != nullptr; }
  /// nullptr where there is none. Valid until the next change.
  const VertexRef* find(Id id) const;
  /// After it, insert() does not allocate.
  void make_room();
  /// The id must be ≥ 0 and new.
  void insert(Id id, VertexRef vertex);
  /// The id must be there.
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

  std::vector<Entry> entries_;  // 2^k, at most three quarters of them not free
  std::size_t size_ = 0, used_ = 0;
};

}  // namespace boxplus
