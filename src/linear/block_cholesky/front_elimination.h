// SPDX-License-Identifier: BSD-3-Clause
// The numerical work on one front of a multifrontal factorization (Duff and Reid 1983; Liu 1992).
#pragma once

#include <cstdint>
#include <span>

#include "boxplus/base/stop_token.h"
#include "kernels/kernel_table.h"
#include "linear/block_cholesky/parallel_front.h"

namespace boxplus {

/// A front whose panel has been loaded with its part of the matrix.
template <class Scalar>
struct LoadedFront {
  Scalar *panel, *update;       // (columns + below) × columns values; below × below values
  const Scalar* minimum_pivot;  // per column
  int columns, below, leading;  // `leading` of the panel
};

/// The update matrix of a child, and the rows of the parent's front to which it is added. The runs before
/// `pivot_runs` end at the parent's pivots.
template <class Scalar>
struct ChildUpdate {
  const Scalar* update;
  int below;
  std::span<const dense::Run> runs;
  std::size_t pivot_runs;
};

/// Adds the update matrices of the children to the front, factorizes its panel, and computes its update
/// matrix. `for_each_child(f)` calls f for each ChildUpdate; it is called twice. Returns the first lost
/// column, kPanelStopped, or the number of columns.
template <class Scalar, class ForEachChild>
int eliminate_front(const LoadedFront<Scalar>& front, int threads, const StopToken& stop,
                    ForEachChild&& for_each_child) {
  for_each_child([&](const ChildUpdate<Scalar>& child) {
    if (child.pivot_runs == 0) return;
    const dense::Run* const runs = child.runs.data();
    extend_add_with<Scalar>(threads, {child.update, child.below, runs, runs + child.pivot_runs,
                                      runs + child.runs.size(), front.panel, front.leading, 0, 0});
  });
  const int good = factor_panel_with(threads, stop, front.panel, front.columns + front.below, front.columns,
                                     front.leading, front.minimum_pivot);
  if (good != front.columns) return good;
  if (!set_to_minus_square_with(threads, stop, front.update, front.below, front.panel + front.columns,
                                front.leading, front.below, front.columns))
    return kPanelStopped;
  for_each_child([&](const ChildUpdate<Scalar>& child) {
    if (child.pivot_runs == child.runs.size()) return;
    const dense::Run *const begin = child.runs.data() + child.pivot_runs, *const end = child.runs.data() +
                                                                                       child.runs.size();
    const auto columns = static_cast<std::uint32_t>(front.columns);
    extend_add_with<Scalar>(
        threads, {child.update, child.below, begin, end, end, front.update, front.below, columns, columns});
  });
  return good;
}

}  // namespace boxplus
