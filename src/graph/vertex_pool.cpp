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
  fixed_directions_.set(slot, {});
  bounds_.set(slot, {});
}

void VertexPool::set_flag(std::uint32_t slot, Flag flag, bool on) {
  flags_[slot] = static_cast<std::uint8_t>(on ? flags_[slot] | flag : flags_[slot] & ~flag);
}

}  // namespace boxplus::detail
