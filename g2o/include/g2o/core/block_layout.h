// SPDX-License-Identifier: BSD-3-Clause
// Helpers for block matrices: the boundaries of blocks, and scalars in compressed column storage (CCS).
#pragma once
#ifndef G2O_BLOCK_LAYOUT_H
#define G2O_BLOCK_LAYOUT_H

#include <cstddef>
#include <vector>

namespace g2o {
namespace internal {

/// Returns the size of block i, given the end row (or column) of each block.
inline int blockSize(const std::vector<int>& ends, int i) {
  const auto at = static_cast<std::size_t>(i);
  return at > 0 ? ends[at] - ends[at - 1] : ends[at];
}

/// Returns the first row (or column) of block i.
inline int blockBase(const std::vector<int>& ends, int i) {
  return i > 0 ? ends[static_cast<std::size_t>(i - 1)] : 0;
}

/// Visits the scalars of a block matrix column by column. Calls `begin` with the index of each column, and
/// `take` with the row and value of each scalar. For an entry of a block column, `rowOf` returns the block
/// row, and `blockOf` returns the block. If `upperTriangle` is true, skips scalars below the diagonal.
template <class Columns, class RowOf, class BlockOf, class Begin, class Take>
void visitScalars(const Columns& columns, const std::vector<int>& rowEnds, const std::vector<int>& colEnds,
                  bool upperTriangle, RowOf&& rowOf, BlockOf&& blockOf, Begin&& begin, Take&& take) {
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const int base = blockBase(colEnds, static_cast<int>(c));
    for (int j = 0; j < blockSize(colEnds, static_cast<int>(c)); ++j) {
      begin(base + j);
      for (const auto& entry : columns[c]) {
        const auto& block = blockOf(entry);
        const int row = blockBase(rowEnds, rowOf(entry));
        for (int i = 0; i < block.rows(); ++i) {
          if (upperTriangle && row + i > base + j) break;
          take(row + i, block(i, j));
        }
      }
    }
  }
}

/// Writes the scalars of a matrix to CCS arrays and returns their number. `visit(begin, take)` must call
/// `begin` and `take` like visitScalars().
template <class Visit>
int fillCCS(Visit&& visit, int cols, int* Cp, int* Ci, double* Cx) {
  int count = 0;
  visit([&](int column) { Cp[column] = count; },
        [&](int row, double value) {
          Ci[count] = row;
          Cx[count++] = value;
        });
  Cp[cols] = count;
  return count;
}
/// Writes only the values of the scalars, in the same order as the other overload.
template <class Visit>
int fillCCS(Visit&& visit, double* Cx) {
  int count = 0;
  visit([](int) {}, [&](int, double value) { Cx[count++] = value; });
  return count;
}

}  // namespace internal
}  // namespace g2o

#endif  // G2O_BLOCK_LAYOUT_H
