// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/id_map.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <iterator>
#include <utility>

namespace boxplus::detail {
namespace {

/// A hash of x. Each bit of the result depends on all bits of x, through xor-shifts and multiplications
/// (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
std::uint64_t mixed(std::uint64_t x) {
  constexpr std::uint64_t kGolden = 0x9E37'79B9'7F4A'7C15;  // 2⁶⁴ divided by the golden ratio
  for (int round = 0; round < 2; ++round) x = (x ^ (x >> 32)) * kGolden;
  return x ^ (x >> 32);
}

}  // namespace

/// The index of the id's entry, or of the free entry that ends the search.
std::size_t IdMap::place_of(Id id) const {
  const auto number = static_cast<std::uint64_t>(id);
  const std::size_t mask = entries_.size() - 1;
  std::size_t place = number & mask;
  const auto ends_search = [&] { return entries_[place].id == id || entries_[place].id == kFree; };
  if (ends_search()) return place;
  const std::size_t stride = mixed(number) | 1;
  do {
    place = (place + stride) & mask;
  } while (!ends_search());
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

}  // namespace boxplus::detail
