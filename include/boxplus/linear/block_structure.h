// SPDX-License-Identifier: BSD-3-Clause
// The sparsity pattern of a symmetric block matrix.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/base/abi.h"
#include "boxplus/base/stop_token.h"

namespace boxplus {

/// The lower triangle, diagonal included, of a symmetric matrix of blocks in compressed block columns.
///
/// Block row or column i spans the scalars [offset[i], offset[i+1]). Column j holds the blocks k in
/// [column_start[j], column_start[j+1]). Block k lies in row row[k]. The rows of a column ascend, and its
/// first block is the diagonal block (j, j). The dim(row[k]) × dim(j) values of block k begin at
/// values[value_start[k]], column-major. Diagonal blocks hold both of their triangles. The values of the
/// columns are contiguous and in order.
struct BlockStructure {
  std::vector<std::uint32_t> offset{0};
  std::vector<std::uint32_t> column_start{0};
  std::vector<std::uint32_t> row;
  std::vector<std::uint32_t> value_start{0};

  std::uint32_t blocks() const { return static_cast<std::uint32_t>(offset.size() - 1); }
  std::uint32_t scalars() const { return offset.back(); }
  std::uint32_t nonzero_blocks() const { return static_cast<std::uint32_t>(row.size()); }
  std::uint32_t nonzero_values() const { return value_start.back(); }
  std::uint32_t dim(std::uint32_t block) const { return offset[block + 1] - offset[block]; }

  /// The index k of block (row, column), row ≥ column, or kAbsent. O(log column length).
  std::uint32_t find(std::uint32_t row_block, std::uint32_t column_block) const;

  static constexpr std::uint32_t kAbsent = 0xFFFFFFFFu;
  bool operator==(const BlockStructure&) const = default;
};

/// Builds the structure of `dims.size()` blocks from the coordinates of its lower off-diagonal blocks
/// (row > column; any order, duplicates allowed). Diagonal blocks are always present. O(blocks + n log n) for
/// n = lower.size(). Throws Stopped when the token is raised.
struct BlockCoordinate {
  std::uint32_t row, column;
};
BlockStructure make_block_structure(const std::vector<std::uint32_t>& dims,
                                    const std::vector<BlockCoordinate>& lower, const StopToken& stop = {});

}  // namespace boxplus
