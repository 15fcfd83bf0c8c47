// SPDX-License-Identifier: BSD-3-Clause
#include "guess/start_table.h"

namespace boxplus {
namespace {

constexpr detail::StartEntry kStarts[] = {
    {Start::kAutomatic, nullptr},       {Start::kCurrent, nullptr},
    {Start::kOdometry, guess_odometry}, {Start::kSpanningTree, guess_spanning_tree},
    {Start::kChordal, guess_chordal},
};

}  // namespace

std::span<const detail::StartEntry> detail::start_table() {
  return kStarts;
}

}  // namespace boxplus
