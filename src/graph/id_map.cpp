// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/id_map.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <utility>

namespace boxplus {

/// The index of the id's entry, or of the free one that ends the search for it.
std::size_t IdMap::place_of(Id id) const {
  constexpr std::uint64_t kGolden = 0x9E37'79B9'7F4A'7C15;  // 2⁶⁴ divided by the golden ratio
  const auto number = static_cast<std::uint64_t>(id);
  const std::size_t mask = entries_.size() - 1, stride = ((number * kGolden) >> 32) | 1;
  std::size_t place = number & mask;
  while (entries_[place].id != id && entries_[place].id != kFree) place = (place + stride) & mask;
  return place;
}

const VertexRef* IdMap::find(Id id) const {
  if (id < 0 || entries_.empty()) return nullptr;
  const Entry& entry = entries_[place_of(id)];
  return entry.id == id ? &entry.vertex : nullptr;
}

void IdMap::make_room() {
  constexpr std::size_t kSmallest = 16;
  if (4 * (used_ + 1) <= 3 * entries_.size()) return;
  std::size_t capacity = std::max(kSmallest, entries_.size());
  while (capacity < 2 * (size_ + 1)) capacity *= 2;
  IdMap larger;
  larger.entries_.resize(capacity);
  for (const Entry& entry : entries_) {
    if (entry.id >= 0) larger.insert(entry.id, entry.vertex);
  }
  *this = std::move(larger);
}

void IdMap::insert(Id id, VertexRef vertex) {
  make_room();
  Entry& entry = entries_[place_of(id)];
  assert(entry.id == kFree);
  entry = {id, vertex};
  ++size_;
  ++used_;
}

void IdMap::erase(Id id) {
  Entry& entry = entries_[place_of(id)];
  assert(entry.id == id);
  entry.id = kErased;
  --size_;
}

std::vector<VertexRef> IdMap::by_id() const {
  std::vector<Entry> sorted;
  sorted.reserve(size_);
  std::copy_if(entries_.begin(), entries_.end(), std::back_inserter(sorted),
               [](const Entry& entry) { return entry.id >= 0; });
  std::sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
  std::vector<VertexRef> result;
  result.reserve(size_);
  for (const Entry& entry : sorted) result.push_back(entry.vertex);
  return result;
}

}  // namespace boxplus
