// SPDX-License-Identifier: BSD-3-Clause
// The elimination tree of a block matrix, with postorders and column counts.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

// All functions of this header that have a StopToken throw Stopped when the token is raised. postorder() is
// so fast that it needs no token.

inline constexpr std::uint32_t kNoParent = BlockStructure::kAbsent;

/// The rows of the nonzero blocks in the strictly upper triangle of the permuted matrix, by column, in
/// compressed form. order[k] is the block of the structure that is the k-th to be eliminated.
struct UpperPattern {
  std::vector<std::uint32_t> column_start, row;
  UpperPattern(const BlockStructure& structure, std::span<const std::uint32_t> order,
               const StopToken& stop = {});
  std::uint32_t columns() const { return static_cast<std::uint32_t>(column_start.size() - 1); }
  std::span<const std::uint32_t> rows(std::uint32_t column) const {
    return std::span(row).subspan(column_start[column], column_start[column + 1] - column_start[column]);
  }
};

/// parent[j] = the first row below the diagonal of column j of L, or kNoParent (Liu 1986, with path
/// compression).
std::vector<std::uint32_t> elimination_tree(const UpperPattern& pattern, const StopToken& stop = {});

/// A sequence of the nodes in which children precede their parents, and every subtree is contiguous (except
/// for the kept nodes). The last `keep` nodes keep their places. Requires parent[j] > j.
std::vector<std::uint32_t> postorder(std::span<const std::uint32_t> parent, std::uint32_t keep);

/// The sizes of the columns of L below the diagonal.
struct ColumnCounts {
  std::vector<std::uint32_t> blocks, scalars;
};

/// Computes the column counts. Visits the row subtrees (Liu 1990, section 5), in O(blocks of L) time and
/// O(columns) memory. The method of Gilbert, Ng and Peyton (1994), whose time is nearly linear in the
/// nonzeros of H, would be only slightly faster here, because this function visits blocks and not scalars.
ColumnCounts count_columns(const UpperPattern& pattern, std::span<const std::uint32_t> parent,
                           std::span<const std::uint32_t> dims, const StopToken& stop = {});

}  // namespace boxplus
