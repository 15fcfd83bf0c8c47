// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/path_tree.h"

#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace boxplus::outliers {

Neighbors::Neighbors(std::size_t poses, std::span<const PoseEdge* const> edges)
    : start_(poses + 1, 0), edges_(2 * edges.size()) {
  for (const PoseEdge* edge : edges) {
    ++start_[edge->from + 1];
    ++start_[edge->to + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const PoseEdge* edge : edges) {
    edges_[next[edge->from]++] = edge;
    edges_[next[edge->to]++] = edge;
  }
}

PathTree::PathTree(const Neighbors& neighbors, std::span<const Motion> estimates, std::uint32_t root,
                   double lever)
    : estimates_(estimates),
      root_(root),
      parent_(estimates.size(), kNone),
      depth_(estimates.size(), 0),
      jump_(estimates.size(), root),
      sums_(estimates.size()) {
  std::vector<double> length(estimates.size(), std::numeric_limits<double>::infinity());
  std::vector<const PoseEdge*> arrival(estimates.size(), nullptr);
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  length[root] = 0;
  queue.emplace(0, root);
  while (!queue.empty()) {
    const auto [reached, pose] = queue.top();
    queue.pop();
    if (reached > length[pose]) continue;
    if (const PoseEdge* edge = arrival[pose]) {
      set_parent(pose, edge->from == pose ? edge->to : edge->from);
      sums_[pose] = sums_[parent_[pose]];
      sums_[pose].add(edge->spread, estimates[pose].translation);
    }
    for (const PoseEdge* edge : neighbors.of(pose)) {
      const std::uint32_t other = edge->from == pose ? edge->to : edge->from;
      const double through = reached + edge->spread.translation + lever * lever * edge->spread.rotation;
      if (!(through < length[other])) continue;
      length[other] = through;
      arrival[other] = edge;
      queue.emplace(through, other);
    }
  }
}

void PathTree::set_parent(std::uint32_t pose, std::uint32_t parent) {
  parent_[pose] = parent;
  depth_[pose] = depth_[parent] + 1;
  // Two jumps of one length become one of about twice the length.
  const std::uint32_t first = jump_[parent], second = jump_[first];
  const bool are_equal = depth_[parent] - depth_[first] == depth_[first] - depth_[second];
  jump_[pose] = are_equal ? second : parent;
}

std::uint32_t PathTree::common_ancestor(std::uint32_t a, std::uint32_t b) const {
  if (depth_[a] < depth_[b]) std::swap(a, b);
  while (depth_[a] > depth_[b]) a = depth_[jump_[a]] >= depth_[b] ? jump_[a] : parent_[a];
  while (a != b) {  // the jumps of poses of one depth have one length
    const bool is_below = jump_[a] != jump_[b];
    a = is_below ? jump_[a] : parent_[a];
    b = is_below ? jump_[b] : parent_[b];
  }
  return a;
}

std::optional<Spread> PathTree::between(std::uint32_t a, std::uint32_t b) const {
  if (!reaches(a) || !reaches(b)) return std::nullopt;
  const std::uint32_t top = common_ancestor(a, b);
  const PathSums path = (sums_[a] - sums_[top]) + (sums_[b] - sums_[top]);
  return path.spread_at(estimates_[b].translation);
}

}  // namespace boxplus::outliers
