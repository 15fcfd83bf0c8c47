// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "boxplus/linear/block_structure.h"

namespace boxplus {

/// Finds the first value of a block. If S is dense, it has many fewer blocks than pairs of observations, so
/// that a table of all pairs of blocks saves the search for each of them.
class FirstValues {
 public:
  explicit FirstValues(const BlockStructure& structure) : structure_(structure), blocks_(structure.blocks()) {
    constexpr std::size_t kDense = 16;
    if (structure.row.size() < blocks_ * blocks_ / kDense) return;
    table_.resize(blocks_ * blocks_);
    for (std::uint32_t column = 0; column < blocks_; ++column) {
      for (std::uint32_t k = structure.column_start[column]; k < structure.column_start[column + 1]; ++k)
        table_[column * blocks_ + structure.row[k]] = structure.value_start[k];
    }
  }

  /// The block (row, column) must exist.
  std::uint32_t operator()(std::uint32_t row, std::uint32_t column) const {
    return table_.empty() ? structure_.value_start[structure_.find(row, column)]
                          : table_[column * blocks_ + row];
  }

 private:
  const BlockStructure& structure_;
  std::size_t blocks_;
  std::vector<std::uint32_t> table_;
};

}  // namespace boxplus
