// SPDX-License-Identifier: BSD-3-Clause
// Searches a matrix for NaN and Inf.
#pragma once

#include <cstdint>

#include "base/all_finite.h"
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// The number of the first block column of the matrix or its damping that has a value that is not finite, or
/// kAbsent.
std::uint32_t find_not_finite(const BlockStructure& structure, const double* values, const Damping& damping);

/// The same for the diagonal blocks only, in the layout of BlockSystem::block_diagonal().
std::uint32_t find_not_finite_diagonal(const BlockStructure& structure, const double* diagonal_blocks,
                                       const Damping& damping);

}  // namespace boxplus
