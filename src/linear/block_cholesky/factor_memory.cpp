// SPDX-License-Identifier: BSD-3-Clause
#include "linear/block_cholesky/factor_memory.h"

#include <algorithm>

#include "boxplus/base/error.h"
#include "linear/block_cholesky/memory_plan.h"

namespace boxplus {
namespace {

/// Places the panels one after the other, and finds the largest sizes of all fronts.
void place_panels(SymbolicFactor& f, PacedStop& pace) {
  f.panel_size = f.all_rows = 0;
  f.largest_front = f.most_columns = f.most_below = 0;
  for (Front& front : f.fronts) {
    pace.step();
    const std::uint64_t size = std::uint64_t{front.leading} * front.columns;
    if (size >= kNoParent) throw Error("block Cholesky: a front has more than 2^32 values");
    front.panel = f.panel_size;
    f.panel_size += size;
    front.first_row = f.all_rows;
    f.all_rows += front.rows();
    f.largest_front = std::max(f.largest_front, front.rows());
    f.most_columns = std::max(f.most_columns, front.columns);
    f.most_below = std::max(f.most_below, front.below);
  }
}

/// Reserves memory for the front's update matrix while the update matrices of its children are still in use.
/// Places it after the panels and after the first `base` values of the memory for update matrices. Then
/// releases the update matrices of the children that `plan` placed.
void place_update(SymbolicFactor& f, Front& front, MemoryPlan& plan, std::uint64_t base) {
  const std::uint64_t below = front.below, origin = f.panel_size + base;
  front.update = origin + plan.reserve(below * below);
  for (const std::uint32_t c : f.children_of(front)) {
    const Front& child = f.fronts[c];
    const std::uint64_t rows = child.below;
    if (child.update >= origin) plan.release(child.update - origin, rows * rows);
  }
}

}  // namespace

/// Each update matrix gets the first place that is large enough. Different subtrees share no memory, so that
/// several threads can factorize them at the same time.
void assign_memory(SymbolicFactor& f, PacedStop& pace) {
  place_panels(f, pace);
  f.update_size = 0;
  const auto place = [&](std::uint32_t s, MemoryPlan& plan, std::uint64_t base) {
    pace.step(4);
    place_update(f, f.fronts[s], plan, base);
  };
  MemoryPlan updates;
  if (!f.schedule.is_parallel()) {
    for (std::uint32_t s = 0; s < f.fronts.size(); ++s) place(s, updates, 0);
    f.update_size = updates.peak();
    return;
  }
  for (const auto& share : f.schedule.threads) {
    for (const auto& subtree : share) {
      MemoryPlan own;
      for (std::uint32_t s = subtree.begin; s < subtree.end; ++s) place(s, own, f.update_size);
      f.update_size += own.peak();
    }
  }
  // The memory of the subtrees' roots is not released for reuse, because the top fronts have separate memory.
  for (const std::uint32_t s : f.schedule.top) place(s, updates, f.update_size);
  f.update_size += updates.peak();
}

std::uint32_t choose_leading(std::uint32_t rows) {
  if (rows <= 32) return rows;
  const std::uint32_t rounded = (rows + 3) / 4 * 4;
  return rounded % 64 == 0 ? rounded + 4 : rounded;
}

}  // namespace boxplus
