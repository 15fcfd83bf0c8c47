// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/vertex_pool.h"

#include <utility>

#include "boxplus/graph/make_room.h"

namespace boxplus::detail {

std::uint32_t VertexPool::acquire_slot(Id id) {
  if (!free_.empty()) {
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    ids_[slot] = id;
    generations_[slot] = next_generation_++;
    flags_[slot] = kAlive;
    return slot;
  }
  make_room(ids_);
  make_room(generations_);
  make_room(flags_);
  ids_.push_back(id);
  generations_.push_back(next_generation_++);
  flags_.push_back(kAlive);
  return slots() - 1;
}

void VertexPool::release_slot(std::uint32_t slot) {
  free_.push_back(slot);
  flags_[slot] = 0;
  if (slot < fixed_directions_.size()) set_fixed_directions(slot, {});
}

void VertexPool::set_fixed_directions(std::uint32_t slot, std::vector<int> directions) {
  if (slot >= fixed_directions_.size()) {
    if (directions.empty()) return;
    fixed_directions_.resize(slots());
  }
  fixed_directions_[slot] = std::move(directions);
  // So has_fixed_directions() is false if no vertex has any.
  while (!fixed_directions_.empty() && fixed_directions_.back().empty()) fixed_directions_.pop_back();
}

void VertexPool::set_flag(std::uint32_t slot, Flag flag, bool on) {
  flags_[slot] = static_cast<std::uint8_t>(on ? flags_[slot] | flag : flags_[slot] & ~flag);
}

}  // namespace boxplus::detail
