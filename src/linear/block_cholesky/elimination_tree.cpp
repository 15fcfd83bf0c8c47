// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/elimination_tree.h"

#include <algorithm>
#include <utility>

#include "base/paced_stop.h"

namespace boxplus {

UpperPattern::UpperPattern(const BlockStructure& structure, std::span<const std::uint32_t> order,
                           const StopToken& stop)
    : column_start(order.size() + 1, 0) {
  PacedStop pace(stop);
  std::vector<std::uint32_t> position(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) position[order[k]] = k;
  const auto for_each_pair = [&](auto visit) {
    for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
      for (std::uint32_t k = structure.column_start[j] + 1; k < structure.column_start[j + 1]; ++k) {
        pace.step();
        const auto [low, high] = std::minmax(position[j], position[structure.row[k]]);
        visit(low, high);
      }
    }
  };
  for_each_pair([&](std::uint32_t, std::uint32_t high) { ++column_start[high + 1]; });
  for (std::size_t j = 0; j < order.size(); ++j) column_start[j + 1] += column_start[j];
  std::vector<std::uint32_t> next(column_start.begin(), column_start.end() - 1);
  row.resize(column_start.back());
  for_each_pair([&](std::uint32_t low, std::uint32_t high) { row[next[high]++] = low; });
}

std::vector<std::uint32_t> elimination_tree(const UpperPattern& pattern, const StopToken& stop) {
  PacedStop pace(stop);
  std::vector<std::uint32_t> parent(pattern.columns(), kNoParent), ancestor(pattern.columns(), kNoParent);
  for (std::uint32_t j = 0; j < pattern.columns(); ++j) {
    for (std::uint32_t i : pattern.rows(j)) {
      while (i != kNoParent && i < j) {
        pace.step();
        const std::uint32_t next = std::exchange(ancestor[i], j);
        if (next == kNoParent) parent[i] = j;
        i = next;
      }
    }
  }
  return parent;
}

std::vector<std::uint32_t> postorder(std::span<const std::uint32_t> parent, std::uint32_t keep) {
  const auto count = static_cast<std::uint32_t>(parent.size());
  const std::uint32_t movable = count - keep;
  // The lists of children. Each list is in ascending order, because it is filled from the back. The index
  // `movable` stands for all kept nodes together, and for the missing parent of a root.
  std::vector<std::uint32_t> first(movable + 1, kNoParent), sibling(movable, kNoParent);
  for (std::uint32_t j = movable; j-- > 0;) {
    const std::uint32_t p = std::min(parent[j], movable);
    sibling[j] = std::exchange(first[p], j);
  }
  std::vector<std::uint32_t> sequence, stack{movable};
  sequence.reserve(count);
  while (!stack.empty()) {
    const std::uint32_t node = stack.back();
    if (const std::uint32_t child = first[node]; child != kNoParent) {
      first[node] = sibling[child];
      stack.push_back(child);
    } else {
      stack.pop_back();
      if (node != movable) sequence.push_back(node);
    }
  }
  for (std::uint32_t j = movable; j < count; ++j) sequence.push_back(j);
  return sequence;
}

ColumnCounts count_columns(const UpperPattern& pattern, std::span<const std::uint32_t> parent,
                           std::span<const std::uint32_t> dims, const StopToken& stop) {
  PacedStop pace(stop, 8 * PacedStop::kSteps);  // fewer checks, because the steps are short
  const std::uint32_t columns = pattern.columns();
  ColumnCounts counts{std::vector<std::uint32_t>(columns, 0), std::vector<std::uint32_t>(columns, 0)};
  std::vector<std::uint32_t> mark(columns, kNoParent);
  for (std::uint32_t i = 0; i < columns; ++i) {
    mark[i] = i;
    for (std::uint32_t j : pattern.rows(i)) {
      for (; mark[j] != i; j = parent[j]) {
        pace.step();
        mark[j] = i;
        ++counts.blocks[j];
        counts.scalars[j] += dims[i];
      }
    }
  }
  return counts;
}

}  // namespace boxplus
