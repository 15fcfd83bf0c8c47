// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/linear/block_structure.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/paced_stop.h"
#include "boxplus/base/error.h"

namespace boxplus {
namespace {

void check_coordinate(BlockCoordinate entry, std::size_t blocks) {
  if (entry.row >= blocks || entry.column >= entry.row) {
    throw InvalidArgument("make_block_structure: expected column < row < " + std::to_string(blocks) +
                          ", got row " + std::to_string(entry.row) + ", column " +
                          std::to_string(entry.column));
  }
}

std::uint32_t checked_size(std::uint64_t size) {
  if (size >= BlockStructure::kAbsent) {
    throw InvalidArgument("make_block_structure: expected fewer than 2^32 − 1 values, got " +
                          std::to_string(size));
  }
  return static_cast<std::uint32_t>(size);
}

/// Lists the rows of each column by a counting sort. Then drops duplicates, and sorts the rows of each
/// column.
void fill_columns(BlockStructure& structure, const std::vector<BlockCoordinate>& lower, PacedStop& pace) {
  const std::uint32_t blocks = structure.blocks();
  std::vector<std::uint32_t> next(blocks + 1, 0);
  for (std::uint32_t j = 0; j < blocks; ++j) next[j + 1] = 1;
  for (const auto& entry : lower) {
    pace.step();
    ++next[entry.column + 1];
  }
  for (std::uint32_t j = 0; j < blocks; ++j) next[j + 1] += next[j];
  std::vector<std::uint32_t> row(next.back());
  const std::vector<std::uint32_t> start = next;
  for (std::uint32_t j = 0; j < blocks; ++j) row[next[j]++] = j;
  for (const auto& entry : lower) {
    pace.step();
    row[next[entry.column]++] = entry.row;
  }
  structure.row.reserve(row.size());
  std::vector<std::uint32_t> last_column(blocks, blocks);  // the last column in which each row was seen
  for (std::uint32_t j = 0; j < blocks; ++j) {
    const auto begin = row.begin() + start[j];
    auto end = row.begin() + start[j + 1];
    pace.step(end - begin);
    end = std::remove_if(begin, end, [&](std::uint32_t i) { return std::exchange(last_column[i], j) == j; });
    std::sort(begin, end);
    structure.row.insert(structure.row.end(), begin, end);
    structure.column_start.push_back(checked_size(structure.row.size()));
  }
}

}  // namespace

std::uint32_t BlockStructure::find(std::uint32_t row_block, std::uint32_t column_block) const {
  if (row_block < column_block || row_block >= blocks()) return kAbsent;
  // If the column is full up to this row, its place is known.
  const std::uint32_t first = column_start[column_block], distance = row_block - column_block;
  if (distance < column_start[column_block + 1] - first && row[first + distance] == row_block)
    return first + distance;
  const auto begin = row.begin() + column_start[column_block];
  const auto end = row.begin() + column_start[column_block + 1];
  const auto found = std::lower_bound(begin, end, row_block);
  return found != end && *found == row_block ? static_cast<std::uint32_t>(found - row.begin()) : kAbsent;
}

BlockStructure make_block_structure(const std::vector<std::uint32_t>& dims,
                                    const std::vector<BlockCoordinate>& lower, const StopToken& stop) {
  BlockStructure structure;
  PacedStop pace(stop);
  structure.offset.reserve(dims.size() + 1);
  std::uint64_t scalars = 0;
  for (const std::uint32_t dim : dims) structure.offset.push_back(checked_size(scalars += dim));
  for (const auto& entry : lower) {
    pace.step();
    check_coordinate(entry, dims.size());
  }
  structure.column_start.reserve(dims.size() + 1);
  checked_size(lower.size() + dims.size());
  fill_columns(structure, lower, pace);
  structure.value_start.reserve(structure.row.size() + 1);
  std::uint64_t values = 0;
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    for (std::uint32_t k = structure.column_start[j]; k < structure.column_start[j + 1]; ++k) {
      pace.step();
      values += std::uint64_t{structure.dim(structure.row[k])} * structure.dim(j);
      structure.value_start.push_back(checked_size(values));
    }
  }
  return structure;
}

}  // namespace boxplus
