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

bool all_finite(const double* values, std::size_t size) {
  double zeros[4] = {};  // x − x is 0, or NaN where x is not finite
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) zeros[lane] += values[i + lane] - values[i + lane];
  }
  for (; i < size; ++i) zeros[0] += values[i] - values[i];
  return zeros[0] + zeros[1] + zeros[2] + zeros[3] == 0;
}

std::uint32_t find_not_finite(const BlockStructure& structure, const double* values, const Damping& damping) {
  for (std::uint32_t j = 0; j < structure.blocks(); ++j) {
    const std::uint32_t begin = structure.value_start[structure.column_start[j]];
    const std::uint32_t end = structure.value_start[structure.column_start[j + 1]];
    if (!all_finite(values + begin, end - begin) || !damping_is_finite(structure, j, damping)) return j;
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
