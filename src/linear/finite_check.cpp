// SPDX-License-Identifier: BSD-3-Clause
#include "linear/finite_check.h"

#include <cmath>

namespace boxplus {
namespace {

bool damping_is_finite(const BlockStructure& structure, std::uint32_t block, const Damping& damping) {
  for (std::uint32_t i = structure.offset[block]; i < structure.offset[block + 1]; ++i) {
    if (!std::isfinite(damping(i))) return false;
  }
  return true;
}

}  // namespace

std::uint32_t find_not_finite(const BlockStructure& structure, const double* values, const Damping& damping,
                              std::uint32_t first) {
  for (std::uint32_t j = first; j < structure.blocks(); ++j) {
    const std::uint32_t size = structure.value_start[structure.column_start[j + 1]] -
                               structure.value_start[structure.column_start[j]];
    if (!all_finite(values, size) || !damping_is_finite(structure, j, damping)) return j;
    values += size;
  }
  return BlockStructure::kAbsent;
}

std::uint32_t find_not_finite_diagonal(const BlockStructure& structure, const double* diagonal_blocks,
                                       const Damping& damping) {
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    const std::size_t size = std::size_t{structure.dim(j)} * structure.dim(j);
    if (!all_finite(diagonal_blocks, size) || !damping_is_finite(structure, j, damping)) return j;
    diagonal_blocks += size;
  }
  return BlockStructure::kAbsent;
}

}  // namespace boxplus
