// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <queue>
#include <utility>

#include "linear/block_cholesky/symbolic_factor.h"
#include "linear/block_cholesky/tree_schedule.h"

namespace boxplus {
namespace {

using Subtree = TreeSchedule::Subtree;

constexpr double kMinSavedNanoseconds = 200e3;  // the time that a worker may take to wake up
constexpr double kSubtreesPerThread = 8;        // a larger number of subtrees does not help
constexpr double kSerialShare = 0.2;            // the part of a front's work that only one thread can do
constexpr double kJoin = 20e3;  // the ns per front that threads lose by waiting for each other

/// The fronts, divided into disjoint subtrees and `top`, the fronts above them. The subtrees are sorted by
/// predicted time, the longest first.
struct Parts {
  std::vector<Subtree> subtrees;
  std::vector<std::uint32_t> top;
  double top_time = 0;  // the predicted time of the fronts in `top`, if all threads work on each front
};

bool is_longer(const Subtree& a, const Subtree& b) {
  return a.time > b.time || (a.time == b.time && a.begin < b.begin);
}

double time_together(double time_alone, int threads) {
  const double shared = time_alone * (kSerialShare + (1 - kSerialShare) / threads) + kJoin;
  return std::min(time_alone, shared);
}

/// A forest of fronts, and its division into parts. Each split moves the root of a subtree to the top part.
class Forest {
 public:
  Forest(std::span<const Front> fronts, const AmalgamationRule& rule, int threads);

  double total() const { return total_; }
  const Parts& parts() const { return parts_; }
  /// Removes the root of the longest subtree. Returns false if no subtree takes longer than `limit`.
  bool split(double limit);

 private:
  bool is_contiguous(std::uint32_t root) const { return size_[root] == of_[root].end - of_[root].begin; }
  void take(std::uint32_t root);

  std::vector<double> own_;
  std::vector<Subtree> of_;  // the subtree of each front
  std::vector<std::uint32_t> size_, first_child_, next_sibling_;
  int threads_;
  Parts parts_;
  double total_ = 0;
};

Forest::Forest(std::span<const Front> fronts, const AmalgamationRule& rule, int threads)
    : size_(fronts.size(), 1),
      first_child_(fronts.size(), kNoParent),
      next_sibling_(first_child_),
      threads_(threads) {
  const auto count = static_cast<std::uint32_t>(fronts.size());
  for (std::uint32_t s = 0; s < count; ++s) {
    own_.push_back(predicted_time(rule, fronts[s].columns, fronts[s].below));
    of_.push_back({s, s + 1, own_[s]});
    total_ += own_[s];
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    const std::uint32_t p = fronts[s].parent;
    if (p == kNoParent) continue;
    of_[p].begin = std::min(of_[p].begin, of_[s].begin);
    of_[p].time += of_[s].time;
    size_[p] += size_[s];
    next_sibling_[s] = first_child_[p];
    first_child_[p] = s;
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    if (fronts[s].parent != kNoParent) continue;
    if (is_contiguous(s)) {
      parts_.subtrees.push_back(of_[s]);
    } else {
      take(s);
    }
  }
  std::sort(parts_.subtrees.begin(), parts_.subtrees.end(), is_longer);
}

/// Moves the root to the top part, and adds the subtrees of its children. If the subtree of a child is not
/// contiguous, splits it in the same way, because a thread needs a contiguous range of fronts. (A subtree can
/// have gaps if it contains some of the last columns, which partition_columns() keeps in their places.)
void Forest::take(std::uint32_t root) {
  std::vector<std::uint32_t> waiting{root};
  while (!waiting.empty()) {
    const std::uint32_t taken = waiting.back();
    waiting.pop_back();
    parts_.top.push_back(taken);
    parts_.top_time += time_together(own_[taken], threads_);
    for (std::uint32_t c = first_child_[taken]; c != kNoParent; c = next_sibling_[c]) {
      if (is_contiguous(c)) {
        parts_.subtrees.push_back(of_[c]);
      } else {
        waiting.push_back(c);
      }
    }
  }
}

bool Forest::split(double limit) {
  auto& subtrees = parts_.subtrees;
  if (subtrees.empty() || subtrees.front().time <= limit) return false;
  const std::uint32_t root = subtrees.front().end - 1;
  subtrees.erase(subtrees.begin());
  const auto old_count = static_cast<std::ptrdiff_t>(subtrees.size());
  take(root);
  const auto first_new = subtrees.begin() + old_count;
  std::sort(first_new, subtrees.end(), is_longer);
  std::inplace_merge(subtrees.begin(), first_new, subtrees.end(), is_longer);
  return true;
}

/// Assigns each subtree, with the longest one first, to the thread that has the least work so far. Returns
/// the time of the busiest thread.
double share_out(const std::vector<Subtree>& subtrees, int threads,
                 std::vector<std::vector<Subtree>>* shares = nullptr) {
  using Load = std::pair<double, std::size_t>;
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (std::size_t t = 0; t < static_cast<std::size_t>(threads); ++t) loads.push({0, t});
  double most = 0;
  for (const Subtree& subtree : subtrees) {
    auto [load, thread] = loads.top();
    loads.pop();
    if (shares) (*shares)[thread].push_back(subtree);
    load += subtree.time;
    most = std::max(most, load);
    loads.push({load, thread});
  }
  return most;
}

double predicted_time(const Parts& parts, int threads) {
  return share_out(parts.subtrees, threads) + parts.top_time;
}

/// Splits subtrees until all of them are short. Of all divisions that occur, returns the one with the
/// shortest predicted time.
Parts best_parts(Forest& forest, int threads) {
  const double limit = forest.total() / (kSubtreesPerThread * threads);
  Parts best = forest.parts();
  double least = predicted_time(best, threads);
  while (forest.split(limit)) {
    if (const double time = predicted_time(forest.parts(), threads); time < least) {
      least = time;
      best = forest.parts();
    }
  }
  return best;
}

}  // namespace

TreeSchedule make_schedule(std::span<const Front> fronts, const AmalgamationRule& rule, int threads) {
  TreeSchedule schedule;
  if (threads <= 1) return schedule;
  Forest forest(fronts, rule, threads);
  const double alone = forest.total();
  if (alone < kMinSavedNanoseconds) return schedule;
  Parts parts = best_parts(forest, threads);
  if (alone - predicted_time(parts, threads) < kMinSavedNanoseconds) return schedule;
  schedule.threads.resize(static_cast<std::size_t>(threads));
  share_out(parts.subtrees, threads, &schedule.threads);
  for (auto& share : schedule.threads) {
    std::sort(share.begin(), share.end(), [](const auto& a, const auto& b) { return a.begin < b.begin; });
  }
  schedule.top = std::move(parts.top);
  std::sort(schedule.top.begin(), schedule.top.end());
  return schedule;
}

}  // namespace boxplus
