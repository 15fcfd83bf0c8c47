// SPDX-License-Identifier: BSD-3-Clause
// Groups of block columns of L that are stored and eliminated as one dense front.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernels/kernel_table.h"
#include "linear/block_cholesky/elimination_tree.h"

namespace boxplus {

/// Supernode s holds the columns order[start[s]] … order[start[s + 1] − 1] of the input numbering; the new
/// order keeps children before parents, and each subtree contiguous (up to the kept columns).
struct SupernodePartition {
  std::vector<std::uint32_t> start{0};
  std::vector<std::uint32_t> order;
  double nanoseconds = 0;  ///< predicted for a factorization on one thread
  double numbers = 0;      ///< of all panels and, on one thread, of the update matrices that live at one time
};

/// Limits of amalgamation. The defaults are for the kernels in use.
struct AmalgamationRule {
  double per_front = 200;         ///< ns of fixed work per front
  double per_panel_entry = 0.4;   ///< ns to clear, fill and read back one entry of L
  double per_update_entry = 0.6;  ///< ns to write one entry of an update matrix and add it into the parent
  double per_flop = dense::kernels().nanoseconds_per_flop;
  double max_zero_fraction = 0.3;  ///< hard cap: part of a front's entries of L that may be added zeros
};

/// Nanoseconds for one front.
double predicted_time(const AmalgamationRule& rule, double columns, double below);

/// Finds the fundamental supernodes (Liu, Ng, Peyton 1993) of a postordered tree and merges children into
/// their parents wherever the predicted time (fixed work + entries + flops) falls and the zeros added stay
/// below the cap. The last `keep` columns keep their places and are never merged with others. Throws Stopped
/// once the token is raised.
SupernodePartition partition_columns(std::span<const std::uint32_t> parent, const ColumnCounts& counts,
                                     std::span<const std::uint32_t> dims, std::uint32_t keep,
                                     const AmalgamationRule& rule = {}, const StopToken& stop = {});

}  // namespace boxplus
