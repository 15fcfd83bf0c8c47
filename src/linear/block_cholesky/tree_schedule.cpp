// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/tree_schedule.h"

#include <algorithm>

#include "linear/block_cholesky/symbolic_factor.h"

namespace boxplus {
namespace {

constexpr double kWorthThreads = 300e3;   // ns
constexpr double kSubtreesPerThread = 8;  // at least, so that the shares come out even

/// The largest subtrees below the limit that are contiguous (those of kept blocks may not be).
std::vector<TreeSchedule::Subtree> find_subtrees(std::span<const Front> fronts, const AmalgamationRule& rule,
                                                 int threads, std::vector<std::uint32_t>& top) {
  const auto count = static_cast<std::uint32_t>(fronts.size());
  std::vector<TreeSchedule::Subtree> subtree(count), chosen;
  std::vector<std::uint32_t> size(count, 1);
  double total = 0;
  for (std::uint32_t s = 0; s < count; ++s) subtree[s] = {s, s + 1, 0};
  for (std::uint32_t s = 0; s < count; ++s) {
    const double own = predicted_time(rule, fronts[s].columns, fronts[s].below);
    total += own;
    subtree[s].time += own;
    if (const std::uint32_t p = fronts[s].parent; p != kNoParent) {
      subtree[p].begin = std::min(subtree[p].begin, subtree[s].begin);
      subtree[p].time += subtree[s].time;
      size[p] += size[s];
    }
  }
  if (total < kWorthThreads) return {};
  const double limit = total / (kSubtreesPerThread * threads);
  for (std::uint32_t s = count; s-- > 0;) {
    if (!chosen.empty() && s >= chosen.back().begin && s < chosen.back().end) continue;
    const bool contiguous = size[s] == subtree[s].end - subtree[s].begin;
    if (contiguous && subtree[s].time <= limit) {
      chosen.push_back(subtree[s]);
    } else {
      top.push_back(s);
    }
  }
  std::reverse(top.begin(), top.end());
  return chosen;
}

}  // namespace

TreeSchedule make_schedule(std::span<const Front> fronts, const AmalgamationRule& rule, int threads) {
  TreeSchedule schedule;
  if (threads <= 1) return schedule;
  auto subtrees = find_subtrees(fronts, rule, threads, schedule.top);
  if (subtrees.empty()) return {};
  std::stable_sort(subtrees.begin(), subtrees.end(),
                   [](const auto& a, const auto& b) { return a.time > b.time; });
  schedule.threads.resize(static_cast<std::size_t>(threads));
  std::vector<double> load(schedule.threads.size(), 0);
  for (const auto& subtree : subtrees) {  // longest first, to the thread with the least
    const auto least = static_cast<std::size_t>(std::min_element(load.begin(), load.end()) - load.begin());
    schedule.threads[least].push_back(subtree);
    load[least] += subtree.time;
  }
  for (auto& share : schedule.threads) {
    std::sort(share.begin(), share.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  }
  return schedule;
}

}  // namespace boxplus
