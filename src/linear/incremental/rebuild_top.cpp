// SPDX-License-Identifier: BSD-3-Clause
// The top of the forest of an IncrementalFactor is taken apart, ordered anew and built again.
#include <algorithm>

#include "linear/block_cholesky/factor_memory.h"
#include "linear/block_cholesky/front_runs.h"
#include "linear/incremental/incremental_factor.h"
#include "linear/incremental/top_order.h"

namespace boxplus {

using Index = IncrementalFactor::Index;

Index IncrementalFactor::new_front() {
  if (!free_fronts_.empty()) {
    const Index f = free_fronts_.back();
    free_fronts_.pop_back();
    return f;
  }
  fronts_.emplace_back();
  return static_cast<Index>(fronts_.size() - 1);
}

void IncrementalFactor::free_front(Index f) {
  Front& front = fronts_[f];
  memory_.give_back(front.values, front.size());
  front.blocks.clear();
  front.places.clear();
  front.children.clear();
  front.runs.clear();
  front.parent = kNone;
  front.pivots = front.columns = 0;
  front.is_dirty = front.is_unsolved = front.is_top = front.is_moved = false;
  free_fronts_.push_back(f);
}

void IncrementalFactor::take_top_apart(FactorWork& work) {
  top_.fronts.clear();
  top_.blocks.clear();
  top_.orphans.clear();
  for (const Index b : touched_) {
    for (Index f = blocks_[b].front; f != kNone && !fronts_[f].is_top; f = fronts_[f].parent) {
      fronts_[f].is_top = true;
      top_.fronts.push_back(f);
    }
  }
  std::erase_if(dirty_, [&](Index f) { return fronts_[f].is_top; });
  for (const Index f : top_.fronts) {
    for (const Index b : fronts_[f].pivot_blocks()) {
      blocks_[b].front = kNone;
      if (blocks_[b].is_alive) top_.blocks.push_back(b);
    }
    for (const Index c : fronts_[f].children) {
      if (!fronts_[c].is_top) top_.orphans.push_back(c);
    }
  }
  const std::uint32_t mark = ++marks_;
  for (const Index b : top_.blocks) mark_[b] = mark;
  for (const Index b : touched_) {
    blocks_[b].is_touched = false;
    if (!blocks_[b].is_alive) {
      free_blocks_.push_back(b);
    } else if (mark_[b] != mark) {
      top_.blocks.push_back(b);  // it is new
    }
  }
  touched_.clear();
  std::sort(top_.blocks.begin(), top_.blocks.end(),
            [&](Index a, Index b) { return blocks_[a].age < blocks_[b].age; });
  for (const Index f : top_.fronts) free_front(f);
  work.ordered_blocks += static_cast<std::uint32_t>(top_.blocks.size());
  rebuild();
}

/// The structure of the matrix that remains when the subtrees of the orphans are eliminated.
BlockStructure IncrementalFactor::structure_of_top() {
  BlockStructure structure;
  const auto count = static_cast<std::uint32_t>(top_.blocks.size());
  for (std::uint32_t k = 0; k < count; ++k) local_[top_.blocks[k]] = k;
  auto& orphans = top_.orphans_of;
  orphans.clear();
  for (const Index orphan : top_.orphans) {
    for (const Index b : fronts_[orphan].separator()) orphans.emplace_back(local_[b], orphan);
  }
  std::sort(orphans.begin(), orphans.end());
  auto orphan = orphans.begin();
  structure.offset.reserve(count + 1);
  structure.column_start.reserve(count + 1);
  for (std::uint32_t k = 0; k < count; ++k) {
    const Block& block = blocks_[top_.blocks[k]];
    structure.offset.push_back(structure.offset.back() + block.dim);
    const std::uint32_t mark = ++marks_;
    const std::size_t first = structure.row.size();
    structure.row.push_back(k);
    const auto add = [&](Index b) {
      if (mark_[b] == mark || local_[b] <= k) return;
      mark_[b] = mark;
      structure.row.push_back(local_[b]);
    };
    for (const Index t : block.terms) {
      const std::vector<Index>& members = terms_[t].blocks;
      const bool is_below =
          std::any_of(members.begin(), members.end(), [&](Index b) { return blocks_[b].front != kNone; });
      if (!is_below) std::for_each(members.begin(), members.end(), add);
    }
    for (; orphan != orphans.end() && orphan->first == k; ++orphan) {
      const auto separator = fronts_[orphan->second].separator();
      std::for_each(separator.begin(), separator.end(), add);
    }
    std::sort(structure.row.begin() + static_cast<std::ptrdiff_t>(first), structure.row.end());
    structure.column_start.push_back(static_cast<std::uint32_t>(structure.row.size()));
  }
  structure.value_start.resize(structure.row.size() + 1);
  for (std::uint32_t j = 0; j < count; ++j) {
    for (std::uint32_t e = structure.column_start[j]; e < structure.column_start[j + 1]; ++e) {
      structure.value_start[e + 1] =
          structure.value_start[e] + structure.dim(j) * structure.dim(structure.row[e]);
    }
  }
  return structure;
}

void IncrementalFactor::rebuild() {
  if (top_.blocks.empty()) return;
  const BlockStructure structure = structure_of_top();
  const FactorOutline outline =
      outline_factor(structure, {}, {}, Ordering::kMinimumDegree, 1, order_top(structure));
  const SupernodePartition& partition = outline.partition;
  std::vector<Index> built;
  for (std::size_t s = 0; s + 1 < partition.start.size(); ++s) {
    const Index f = new_front();
    for (std::uint32_t k = partition.start[s]; k < partition.start[s + 1]; ++k) {
      const Index b = top_.blocks[outline.order[partition.order[k]]];
      blocks_[b].sequence = ++sequence_;
      blocks_[b].front = f;
      fronts_[f].blocks.push_back(b);
    }
    fronts_[f].pivots = static_cast<Index>(fronts_[f].blocks.size());
    built.push_back(f);
  }
  for (const Index orphan : top_.orphans) {
    sort_separator(fronts_[orphan]);
    attach(orphan, blocks_[fronts_[orphan].separator()[0]].front);
  }
  for (const Index f : built) {
    Front& front = fronts_[f];
    find_blocks(front);
    for (const Index c : front.children) find_runs(fronts_[c], front);
    if (front.blocks.size() > front.pivots) attach(f, blocks_[front.separator()[0]].front);
    front.values = memory_.take(front.size());
    front.is_dirty = true;
    dirty_.push_back(f);
  }
}

void IncrementalFactor::attach(Index child, Index parent) {
  fronts_[child].parent = parent;
  fronts_[parent].children.push_back(child);
}

void IncrementalFactor::set_places(Front& front) const {
  front.places.clear();
  for (const Index b : front.blocks) front.places.push_back({blocks_[b].x, blocks_[b].dim});
}

/// Appends the separator to the pivots of a front, whose children are known, and computes its sizes.
void IncrementalFactor::find_blocks(Front& front) {
  const std::uint32_t mark = ++marks_;
  const std::uint64_t last = blocks_[front.blocks.back()].sequence;
  const auto add = [&](Index b) {
    if (mark_[b] == mark || blocks_[b].sequence <= last) return;
    mark_[b] = mark;
    front.blocks.push_back(b);
  };
  for (Index k = 0; k < front.pivots; ++k) {
    for (const Index t : blocks_[front.blocks[k]].terms) {
      for (const Index b : terms_[t].blocks) add(b);
    }
  }
  for (const Index c : front.children) {
    for (const Index b : fronts_[c].separator()) add(b);
  }
  std::sort(front.blocks.begin() + front.pivots, front.blocks.end(),
            [&](Index a, Index b) { return blocks_[a].sequence < blocks_[b].sequence; });
  set_places(front);
  front.columns = 0;
  front.below = 1;
  for (const Index b : front.pivot_blocks()) front.columns += dim(b);
  for (const Index b : front.separator()) front.below += dim(b);
  front.leading = choose_leading(front.columns + front.below);
  std::uint32_t row = 0;
  for (const Index b : front.blocks) {
    local_[b] = row;
    row += dim(b);
  }
}

/// Lists where the rows of the child's update matrix are in the front of its parent, whose rows are in
/// local_.
void IncrementalFactor::find_runs(Front& child, const Front& parent) {
  child.runs.clear();
  std::uint32_t source = 0, begin = 0;
  child.pivot_runs = 0;
  for (const Index b : child.separator()) {
    const bool is_pivot = local_[b] < parent.columns;
    if (!is_pivot && begin == 0 && child.pivot_runs > 0) begin = static_cast<std::uint32_t>(child.pivot_runs);
    append_run(child.runs, begin, {source, local_[b], dim(b)});
    source += dim(b);
    if (is_pivot) child.pivot_runs = child.runs.size();
  }
  append_run(child.runs, static_cast<std::uint32_t>(child.pivot_runs),
             {source, parent.columns + parent.below - 1, 1});
}

/// Sorts the separator by the order of elimination. Returns false if nothing changes. local_ then has the old
/// row of each of its blocks in the update matrix.
bool IncrementalFactor::sort_blocks(Front& front) {
  const auto first = front.blocks.begin() + front.pivots;
  const auto before = [&](Index a, Index b) { return blocks_[a].sequence < blocks_[b].sequence; };
  if (std::is_sorted(first, front.blocks.end(), before)) return false;
  std::uint32_t row = 0;
  for (const Index b : front.separator()) {
    local_[b] = row;
    row += dim(b);
  }
  std::sort(first, front.blocks.end(), before);
  set_places(front);
  front.is_moved = true;
  return true;
}

/// Sorts the separator of a computed front. Moves the rows of its panel, and the rows and columns of its
/// update matrix.
void IncrementalFactor::sort_separator(Front& front) {
  if (!sort_blocks(front)) return;
  std::vector<std::uint32_t> from;  // of each new row of the update matrix
  from.reserve(front.below);
  for (const Index b : front.separator()) {
    for (std::uint32_t i = 0; i < dim(b); ++i) from.push_back(local_[b] + i);
  }
  from.push_back(front.below - 1);  // the right-hand side
  const std::size_t below = front.below;
  permuted_.resize(std::max(permuted_.size(), below * below));
  for (std::uint32_t c = 0; c < front.columns; ++c) {
    double* const column = front.values + std::size_t{c} * front.leading + front.columns;
    for (std::size_t r = 0; r < below; ++r) permuted_[r] = column[from[r]];
    std::copy_n(permuted_.begin(), below, column);
  }
  double* const update = front.update();
  for (std::size_t c = 0; c < below; ++c) {
    for (std::size_t r = c; r < below; ++r) {
      const auto [low, high] = std::minmax(from[r], from[c]);
      permuted_[c * below + r] = update[low * below + high];
    }
  }
  std::copy_n(permuted_.begin(), below * below, update);
}

}  // namespace boxplus
