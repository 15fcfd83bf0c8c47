// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/start_table.h"

#include <algorithm>
#include <cassert>
#include <span>

namespace boxplus {
namespace {

struct StartEntry {
  Start start;
  std::string_view name;  // for command lines
  GuessFunction guess;    // null: the estimates are not replaced, or not by one guess alone
};

constexpr StartEntry kStarts[] = {
    {Start::kCurrent, "current", nullptr},
    {Start::kOdometry, "odometry", guess_odometry},
    {Start::kSpanningTree, "spanning-tree", guess_spanning_tree},
    {Start::kChordal, "chordal", guess_chordal},
    {Start::kAutomatic, "automatic", nullptr},
};

const StartEntry* find(Start start) {
  const auto* found = std::find_if(std::begin(kStarts), std::end(kStarts),
                                   [&](const StartEntry& entry) { return entry.start == start; });
  return found == std::end(kStarts) ? nullptr : found;
}

}  // namespace

GuessFunction guess_function(Start start) {
  const StartEntry* entry = find(start);
  assert(entry != nullptr && entry->guess != nullptr);
  return entry->guess;
}

std::string_view to_string(Start start) {
  const StartEntry* entry = find(start);
  return entry == nullptr ? "unknown" : entry->name;
}

}  // namespace boxplus
