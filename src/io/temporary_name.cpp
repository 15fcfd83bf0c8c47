// SPDX-License-Identifier: BSD-3-Clause
#include "io/temporary_name.h"

#include <array>
#include <atomic>
#include <cstring>
#include <utility>

#include "boxplus/io/write_file.h"
#include "platform/files.h"

namespace boxplus {
namespace {

constexpr std::size_t kLongestName = 4096;  // of a path, with a zero at its end

/// A copy of the name of a temporary file. A signal handler can read it at any time, because it is static and
/// never freed.
struct Slot {
  enum State : char { kFree, kChanging, kHolds };
  std::atomic<State> state{kFree};
  std::array<char, kLongestName> name{};
};
static_assert(std::atomic<Slot::State>::is_always_lock_free, "signal handlers must not wait for locks");

constexpr int kSlots = 8;  // the largest number of temporary files that a signal handler can remove
std::array<Slot, kSlots> slots;

/// Copies `name` to a free slot. Returns the index of the slot, or -1 if no slot is free or the name is too
/// long.
int find_slot(const std::string& name) {
  if (name.size() >= kLongestName) return -1;
  for (int k = 0; k < kSlots; ++k) {
    Slot& slot = slots[k];
    Slot::State expected = Slot::kFree;
    if (!slot.state.compare_exchange_strong(expected, Slot::kChanging)) continue;
    std::memcpy(slot.name.data(), name.c_str(), name.size() + 1);
    slot.state = Slot::kHolds;
    return k;
  }
  return -1;
}

}  // namespace

TemporaryName::~TemporaryName() {
  if (!name_.empty()) remove_file(name_.c_str());
  release();
}

void TemporaryName::assign(std::string name) {
  name_ = std::move(name);
  slot_ = find_slot(name_);
}

void TemporaryName::release() {
  if (slot_ >= 0) slots[slot_].state = Slot::kFree;
  slot_ = -1;
  name_.clear();
}

void remove_temporary_files() noexcept {
  for (const Slot& slot : slots) {
    if (slot.state == Slot::kHolds) remove_file(slot.name.data());
  }
}

}  // namespace boxplus
