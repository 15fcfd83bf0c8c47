// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/supernodes.h"

#include <algorithm>
#include <numeric>

#include "base/paced_stop.h"

namespace boxplus {
namespace {

/// A supernode during amalgamation. `merged_into` is the index of the parent into which the node was merged,
/// or the node's own index if it was not merged.
struct Node {
  std::uint32_t first_column, last_column, parent = kNoParent, merged_into;
  double columns, below;  // in scalars
  double zeros = 0;
  bool kept;
};

std::vector<Node> fundamental_supernodes(std::span<const std::uint32_t> parent, const ColumnCounts& counts,
                                         std::span<const std::uint32_t> dims, std::uint32_t keep,
                                         PacedStop& pace) {
  const auto count = static_cast<std::uint32_t>(parent.size());
  std::vector<std::uint32_t> children(count, 0), node_of(count);
  for (const std::uint32_t p : parent) {
    if (p != kNoParent) ++children[p];
  }
  std::vector<Node> nodes;
  for (std::uint32_t j = 0; j < count; ++j) {
    pace.step();
    const bool kept = j >= count - keep;
    const bool joins = j > 0 && parent[j - 1] == j && children[j] == 1 && nodes.back().kept == kept &&
                       counts.blocks[j - 1] == counts.blocks[j] + 1;
    if (!joins) {
      const auto self = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back({j, j, kNoParent, self, 0, 0, 0, kept});
    }
    Node& node = nodes.back();
    node_of[j] = node.merged_into;
    node.last_column = j;
    node.columns += dims[j];
    node.below = counts.scalars[j];
  }
  for (Node& node : nodes) {
    if (parent[node.last_column] != kNoParent) node.parent = node_of[parent[node.last_column]];
  }
  return nodes;
}

double added_zeros(const Node& child, const Node& parent) {
  return child.columns * (parent.columns + parent.below - child.below);
}

bool merging_pays(const Node& child, const Node& parent, const AmalgamationRule& rule) {
  if (child.kept != parent.kept || (child.kept && child.last_column + 1 != parent.first_column)) return false;
  const double columns = child.columns + parent.columns;
  const double entries = columns * (columns + 1) / 2 + columns * parent.below;
  const double zeros = child.zeros + parent.zeros + added_zeros(child, parent);
  return zeros <= rule.max_zero_fraction * entries &&
         predicted_time(rule, columns, parent.below) <=
             predicted_time(rule, child.columns, child.below) +
                 predicted_time(rule, parent.columns, parent.below);
}

void merge(Node& child, Node& parent, std::uint32_t parent_index) {
  parent.zeros += child.zeros + added_zeros(child, parent);
  parent.columns += child.columns;
  if (child.kept) parent.first_column = child.first_column;
  child.merged_into = parent_index;
}

/// The indices 0, 1, … sorted into groups, ascending in each group. Leaves out the indices whose group is
/// kNoParent.
class Groups {
 public:
  Groups(std::span<const std::uint32_t> group_of, std::size_t groups) : start_(groups + 1, 0) {
    for (const std::uint32_t g : group_of) {
      if (g != kNoParent) ++start_[g + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    members_.resize(start_.back());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t k = 0; k < group_of.size(); ++k) {
      if (group_of[k] != kNoParent) members_[next[group_of[k]]++] = k;
    }
  }
  std::span<std::uint32_t> operator[](std::size_t group) {
    return std::span(members_).subspan(start_[group], start_[group + 1] - start_[group]);
  }

 private:
  std::vector<std::uint32_t> start_, members_;
};

/// Merges nodes with their children if merging_pays(). Visits nodes before their parents. For each node,
/// tries first the child whose merge adds the fewest zeros. Does not try the children of a merged child
/// again.
void amalgamate(std::vector<Node>& nodes, const AmalgamationRule& rule, PacedStop& pace) {
  std::vector<std::uint32_t> parents;
  parents.reserve(nodes.size());
  for (const Node& node : nodes) parents.push_back(node.parent);
  Groups children(parents, nodes.size());
  for (std::uint32_t s = 0; s < nodes.size(); ++s) {
    const std::span<std::uint32_t> list = children[s];
    std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
      const double zeros_a = added_zeros(nodes[a], nodes[s]), zeros_b = added_zeros(nodes[b], nodes[s]);
      return zeros_a != zeros_b ? zeros_a < zeros_b : a > b;
    });
    for (const std::uint32_t child : list) {
      pace.step();
      if (merging_pays(nodes[child], nodes[s], rule)) merge(nodes[child], nodes[s], s);
    }
  }
}

/// The number of values in all panels, plus the largest number of values that update matrices hold at the
/// same time. `tops` lists the nodes that remain after merging, and `sequence` is a postorder of them.
double count_numbers(const std::vector<Node>& nodes, std::span<const std::uint32_t> tops,
                     std::span<const std::uint32_t> top_parent, std::span<const std::uint32_t> sequence,
                     PacedStop& pace) {
  double panels = 0, waiting = 0, most_waiting = 0;
  std::vector<double> from_children(tops.size(), 0);
  for (const std::uint32_t top : sequence) {
    pace.step();
    const Node& node = nodes[tops[top]];
    const double update = node.below * node.below;
    panels += node.columns * (node.columns + node.below);
    waiting += update;
    most_waiting = std::max(most_waiting, waiting);
    waiting -= from_children[top];
    if (top_parent[top] != kNoParent) from_children[top_parent[top]] += update;
  }
  return panels + most_waiting;
}

}  // namespace

double predicted_time(const AmalgamationRule& rule, double columns, double below) {
  const double rows = columns + below;
  const double flops = (rows * rows * rows - below * below * below) / 3;
  return rule.per_front + rule.per_panel_entry * rows * columns + rule.per_update_entry * below * below / 2 +
         rule.per_flop * flops;
}

SupernodePartition partition_columns(std::span<const std::uint32_t> parent, const ColumnCounts& counts,
                                     std::span<const std::uint32_t> dims, std::uint32_t keep,
                                     const AmalgamationRule& rule, const StopToken& stop) {
  PacedStop pace(stop);
  std::vector<Node> nodes = fundamental_supernodes(parent, counts, dims, keep, pace);
  const std::vector<Node> fundamental = nodes;  // with the columns before merging
  amalgamate(nodes, rule, pace);
  // Finds the topmost node of each merged set. One backward sweep is enough because parents come after their
  // children.
  const auto count = static_cast<std::uint32_t>(nodes.size());
  std::vector<std::uint32_t> representative(count), number(count, 0), tops;
  for (std::uint32_t s = count; s-- > 0;) {
    pace.step();
    representative[s] = nodes[s].merged_into == s ? s : representative[nodes[s].merged_into];
  }
  for (std::uint32_t s = 0; s < count; ++s) {
    if (representative[s] == s) number[s] = static_cast<std::uint32_t>(tops.size()), tops.push_back(s);
  }
  std::vector<std::uint32_t> top_of(count);
  for (std::uint32_t s = 0; s < count; ++s) top_of[s] = number[representative[s]];
  Groups members(top_of, tops.size());
  std::vector<std::uint32_t> top_parent;
  std::uint32_t kept_tops = 0;
  for (const std::uint32_t s : tops) {
    const std::uint32_t p = nodes[s].parent;
    top_parent.push_back(p == kNoParent ? kNoParent : number[representative[p]]);
    kept_tops += nodes[s].kept;
  }
  SupernodePartition partition;
  partition.order.reserve(parent.size());
  const std::vector<std::uint32_t> sequence = postorder(top_parent, kept_tops);
  partition.numbers = count_numbers(nodes, tops, top_parent, sequence, pace);
  for (const std::uint32_t top : tops)
    partition.nanoseconds += predicted_time(rule, nodes[top].columns, nodes[top].below);
  for (const std::uint32_t top : sequence) {
    for (const std::uint32_t s : members[top]) {
      pace.step();
      for (std::uint32_t j = fundamental[s].first_column; j <= fundamental[s].last_column; ++j) {
        partition.order.push_back(j);
      }
    }
    partition.start.push_back(static_cast<std::uint32_t>(partition.order.size()));
  }
  return partition;
}

}  // namespace boxplus
