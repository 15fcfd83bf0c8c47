// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>

namespace boxplus {

/// Whether all values are finite, that is, neither NaN nor infinite.
inline bool all_finite(const double* values, std::size_t size) {
  double zeros[4] = {};  // x − x is 0 if x is finite, and NaN otherwise
  std::size_t i = 0;
  for (; i + 4 <= size; i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) zeros[lane] += values[i + lane] - values[i + lane];
  }
  for (; i < size; ++i) zeros[0] += values[i] - values[i];
  return zeros[0] + zeros[1] + zeros[2] + zeros[3] == 0;
}

inline bool all_finite(std::span<const double> values) {
  return all_finite(values.data(), values.size());
}

}  // namespace boxplus
