// SPDX-License-Identifier: BSD-3-Clause
// Searches a matrix for NaN and Inf.
#pragma once

#include <cstdint>

#include "base/all_finite.h"
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// The first block column with a value or a damping that is not finite, or kAbsent if all of them are finite.
/// Begins with column `first`, whose first value is the first of `values`.
std::uint32_t find_not_finite(const BlockStructure& structure, const double* values, const Damping& damping,
                              std::uint32_t first = 0);

/// Like find_not_finite(), but checks only the diagonal blocks, in the layout of
/// BlockSystem::block_diagonal().
std::uint32_t find_not_finite_diagonal(const BlockStructure& structure, const double* diagonal_blocks,
                                       const Damping& damping);

}  // namespace boxplus
