// SPDX-License-Identifier: BSD-3-Clause
#include "guess/start_table.h"

namespace boxplus {
namespace {

constexpr detail::StartEntry kStarts[] = {
    {Start::kAutomatic, "automatic", nullptr},
    {Start::kCurrent, "current", nullptr},
    {Start::kOdometry, "odometry", guess_odometry},
    {Start::kSpanningTree, "spanning-tree", guess_spanning_tree},
    {Start::kChordal, "chordal", guess_chordal},
};

}  // namespace

std::span<const detail::StartEntry> detail::start_table() {
  return kStarts;
}

std::string_view to_string(Start start) {
  for (const detail::StartEntry& entry : kStarts) {
    if (entry.start == start) return entry.name;
  }
  return "unknown";
}

}  // namespace boxplus
