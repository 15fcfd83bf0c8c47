// SPDX-License-Identifier: BSD-3-Clause
// Supernodes: groups of block columns of L that are stored and eliminated as one dense front.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/kernel_table.h"
#include "linear/block_cholesky/elimination_tree.h"

namespace boxplus {

/// Supernode s holds the columns order[start[s]] … order[start[s + 1] − 1] of the input numbering. In the new
/// order, children come before parents, and each subtree is contiguous. The only exceptions are the last
/// `keep` columns of partition_columns().
struct SupernodePartition {
  std::vector<std::uint32_t> start{0};
  std::vector<std::uint32_t> order;
  double nanoseconds = 0;  ///< the predicted time of a factorization on one thread
  /// The number of values in all panels, plus the largest number of values that update matrices hold at the
  /// same time on one thread.
  double numbers = 0;
};

/// The cost model and the limit for merging supernodes. The default of per_flop depends on the kernels in
/// use.
struct AmalgamationRule {
  double per_front = 200;         ///< the ns of fixed work per front
  double per_panel_entry = 0.4;   ///< the ns to clear, fill and read back one entry of L
  double per_update_entry = 0.6;  ///< the ns to write one entry of an update matrix and add it to the parent
  double per_flop = dense::kernels().nanoseconds_per_flop;
  double max_zero_fraction = 0.3;  ///< the largest fraction of added zeros in a front's entries of L
};

/// The predicted nanoseconds for one front.
double predicted_time(const AmalgamationRule& rule, double columns, double below);

/// Finds the fundamental supernodes (Liu, Ng, Peyton 1993) of a postordered tree. Then merges a child with
/// its parent if this does not increase the predicted time (fixed work + entries + flops) and the added zeros
/// stay below the limit. The last `keep` columns keep their places and are never merged with other columns.
/// Throws Stopped when the token is raised.
SupernodePartition partition_columns(std::span<const std::uint32_t> parent, const ColumnCounts& counts,
                                     std::span<const std::uint32_t> dims, std::uint32_t keep,
                                     const AmalgamationRule& rule = {}, const StopToken& stop = {});

}  // namespace boxplus
