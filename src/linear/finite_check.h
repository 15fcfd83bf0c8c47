// SPDX-License-Identifier: BSD-3-Clause
// Search for NaN and Inf.
#pragma once

#include <cstdint>

#include "base/all_finite.h"
#include "boxplus/linear/linear_solver.h"

namespace boxplus {

/// The first block (by column; its column's number) of the matrix or its damping that is not finite, or
/// kAbsent.
std::uint32_t find_not_finite(const BlockStructure& structure, const double* values, const Damping& damping);

/// The same for the diagonal blocks alone, stored as BlockSystem::block_diagonal() gives them.
std::uint32_t find_not_finite_diagonal(const BlockStructure& structure, const double* diagonal_blocks,
                                       const Damping& damping);

}  // namespace boxplus
