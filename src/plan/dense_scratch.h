// SPDX-License-Identifier: BSD-3-Clause
// The memory with which large edges are linearized.
#pragma once

#include <algorithm>
#include <cstddef>

namespace boxplus {

/// The number of scratch values that accumulate() needs to use the dense kernels for an edge of this size. It
/// is 0 if these kernels are not faster for this size.
inline std::size_t dense_scratch(int rows, int cols) {
  constexpr int kFewest = 24;  // the fewest rows and columns for which the dense kernels are faster
  if (std::min(rows, cols) < kFewest) return 0;
  return static_cast<std::size_t>(cols) * static_cast<std::size_t>(rows + cols);
}

}  // namespace boxplus
