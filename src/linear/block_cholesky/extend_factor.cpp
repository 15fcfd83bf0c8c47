// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/extend_factor.h"

#include <algorithm>

#include "linear/block_cholesky/factor_memory.h"
#include "linear/block_cholesky/front_runs.h"

namespace boxplus {
namespace {

constexpr std::uint32_t kMostNewBlocks = 16;

template <class T>
std::uint32_t count_of(const std::vector<T>& v) {
  return static_cast<std::uint32_t>(v.size());
}

/// Moves the range [begin, end) of a list to the end of the list, so that the range can grow. The old place
/// of the range remains unused.
template <class T>
void move_to_end(std::vector<T>& list, std::uint32_t& begin, std::uint32_t& end) {
  const std::uint32_t size = end - begin, target = count_of(list);
  for (std::uint32_t k = 0; k < size; ++k) list.push_back(list[begin + k]);
  begin = target;
  end = target + size;
}

class Extension {
 public:
  Extension(const BlockStructure& structure, const StructureGrowth& growth, SymbolicFactor& factor)
      : structure_(structure),
        growth_(growth),
        f_(factor),
        old_(growth.old_blocks),
        new_(structure.blocks() - growth.old_blocks),
        old_fronts_(count_of(factor.fronts)) {}

  bool is_possible() const {
    if (new_ > kMostNewBlocks) return false;
    return std::all_of(growth_.added.begin(), growth_.added.end(), [&](const BlockCoordinate& pair) {
      if (pair.row >= old_) return true;
      const auto [low, high] = std::minmax(f_.position[pair.row], f_.position[pair.column]);
      return f_.row_in(f_.fronts[f_.front_of[low]], high) != kNoParent;
    });
  }

  void run() {
    append_positions();
    find_new_rows();
    for (const std::uint32_t s : touched_) add_rows(s);
    adopt_roots();
    for (const std::uint32_t s : touched_) find_runs_of(s);
    place_blocks();
    for (std::uint32_t k = 0; k < new_; ++k) {
      if (f_.schedule.is_parallel()) f_.schedule.top.push_back(old_fronts_ + k);
    }
    PacedStop pace(never_);
    assign_memory(f_, pace);
  }

 private:
  using Rows = std::uint32_t;  // one bit per new block

  void append_positions() {
    for (std::uint32_t block = old_; block < old_ + new_; ++block) {
      f_.order.push_back(block);
      f_.position.push_back(block);
      f_.offset.push_back(f_.offset.back() + structure_.dim(block));
      f_.front_of.push_back(count_of(f_.fronts));
      Front front{};
      front.first_block = block;
      front.end_block = block + 1;
      front.columns = structure_.dim(block);
      front.parent = kNoParent;
      f_.fronts.push_back(front);
    }
  }

  /// Finds the new rows of each front: the rows of new blocks of H in its columns, and the new rows of its
  /// children. New blocks come last in the elimination order. So a root may get a parent, but the parents of
  /// all other old fronts stay the same.
  void find_new_rows() {
    rows_.assign(f_.fronts.size(), 0);
    for (const BlockCoordinate& pair : growth_.added) {
      if (pair.row >= old_) rows_[f_.front_of[f_.position[pair.column]]] |= Rows{1} << (pair.row - old_);
    }
    for (std::uint32_t s = 0; s < f_.fronts.size(); ++s) {
      Front& front = f_.fronts[s];
      if (rows_[s] == 0 && s < old_fronts_) continue;
      touched_.push_back(s);
      if (rows_[s] == 0) continue;
      if (front.parent == kNoParent) {
        std::uint32_t first = 0;
        while ((rows_[s] >> first & 1) == 0) ++first;
        front.parent = old_fronts_ + first;
      }
      const Rows own = front.parent >= old_fronts_ ? Rows{1} << (front.parent - old_fronts_) : Rows{0};
      rows_[front.parent] |= rows_[s] & ~own;
    }
  }

  void add_rows(std::uint32_t s) {
    Front& front = f_.fronts[s];
    std::uint32_t begin = front.row_begin, end = front.row_end;
    move_to_end(f_.row_offsets, begin, end);
    move_to_end(f_.row_blocks, front.row_begin, front.row_end);  // the same range in both lists
    move_to_end(f_.row_runs, front.row_run_begin, front.row_run_end);
    for (std::uint32_t k = 0; k < new_; ++k) {
      if ((rows_[s] >> k & 1) == 0) continue;
      const std::uint32_t row = old_ + k, dim = structure_.dim(row);
      f_.row_blocks.push_back(row);
      f_.row_offsets.push_back(front.rows());
      append_run(f_.row_runs, front.row_run_begin, {front.below, f_.offset[row], dim});
      add_flops(front, dim);
      front.below += dim;
    }
    front.row_end = count_of(f_.row_blocks);
    front.row_run_end = count_of(f_.row_runs);
    if (s >= old_fronts_) add_flops_of_pivots(front);
    change_leading(front);
  }

  /// Adds the number of operations that `dim` more rows cause. A column with l entries below the diagonal
  /// takes (1 + l)² operations.
  void add_flops(const Front& front, std::uint32_t dim) {
    for (std::uint32_t i = 1; i <= front.columns; ++i) {
      const double before = front.below + double{0} + i, after = before + dim;
      f_.flops += after * after - before * before;
    }
  }
  void add_flops_of_pivots(const Front& front) {
    for (std::uint32_t i = 1; i <= front.columns; ++i) f_.flops += double{1} * i * i;
  }

  void change_leading(Front& front) {
    const std::uint32_t before = front.leading;
    front.leading = choose_leading(front.rows());
    for (std::uint32_t k = front.copy_begin; k < front.copy_end; ++k) {
      std::uint32_t& to = f_.copies[k].destination;
      to = to % before + to / before * front.leading;
    }
  }

  /// Sets the children of the new fronts. The children are former roots and other new fronts.
  void adopt_roots() {
    for (std::uint32_t parent = old_fronts_; parent < f_.fronts.size(); ++parent) {
      f_.fronts[parent].child_begin = count_of(f_.children);
      for (const std::uint32_t s : touched_) {
        if (f_.fronts[s].parent == parent) f_.children.push_back(s);
      }
      f_.fronts[parent].child_end = count_of(f_.children);
    }
  }

  void find_runs_of(std::uint32_t s) {
    Front& child = f_.fronts[s];
    if (child.parent == kNoParent) return;
    const Front& parent = f_.fronts[child.parent];
    find_runs(f_, child, parent, [&](std::uint32_t row) { return f_.row_in(parent, row); });
  }

  /// Updates the sources of the old blocks of H, which have moved, and finds places in the panels for the new
  /// blocks.
  void place_blocks() {
    for (BlockCopy& copy : f_.copies) {
      copy.block = growth_.new_index[copy.block];
      copy.source = structure_.value_start[copy.block];
    }
    for (std::uint32_t block = old_; block < old_ + new_; ++block) place_block(block, block);
    for (const BlockCoordinate& pair : growth_.added) place_block(pair.row, pair.column);
  }

  void place_block(std::uint32_t row, std::uint32_t column) {
    const auto [low, high] = std::minmax(f_.position[row], f_.position[column]);
    Front& front = f_.fronts[f_.front_of[low]];
    const bool transposed = f_.position[column] != low;
    const std::uint32_t index = structure_.find(row, column);
    const std::uint32_t first = f_.offset[low] - f_.offset[front.first_block];
    move_to_end(f_.copies, front.copy_begin, front.copy_end);
    f_.copies.push_back({structure_.value_start[index], f_.row_in(front, high) + first * front.leading, index,
                         structure_.dim(row), structure_.dim(column), transposed});
    ++front.copy_end;
  }

  const BlockStructure& structure_;
  const StructureGrowth& growth_;
  SymbolicFactor& f_;
  const std::uint32_t old_, new_, old_fronts_;
  const StopToken never_;
  std::vector<Rows> rows_;              // the new rows of each front
  std::vector<std::uint32_t> touched_;  // the new fronts and the old fronts with new rows, ascending
};

}  // namespace

bool extend_factor(const BlockStructure& structure, const StructureGrowth& growth, SymbolicFactor& factor) {
  Extension extension(structure, growth, factor);
  if (!extension.is_possible()) return false;
  extension.run();
  return true;
}

double predicted_nanoseconds(const SymbolicFactor& factor, const AmalgamationRule& rule) {
  double total = 0;
  for (const Front& front : factor.fronts) total += predicted_time(rule, front.columns, front.below);
  return total;
}

}  // namespace boxplus
