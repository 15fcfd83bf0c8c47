// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the inverse of H from blocks of the inverse of its Schur complement.
#pragma once

#include <span>

#include "linear/column_inverse.h"
#include "linear/schur/schur.h"

namespace boxplus {

/// With Y = W (V + λD)⁻¹ and S⁻¹ the inverse of the damped Schur complement, which `inner` has factorized,
/// (H + λD)⁻¹ = [(V + λD)⁻¹ + Yᵀ S⁻¹ Y, −Yᵀ S⁻¹; −S⁻¹ Y, S⁻¹]. Fills the requests; asks `inner` once, for the
/// blocks of S⁻¹ that they need: for eliminated blocks those of the rows that they are joined with. False if
/// `inner` cannot do it, or `stop` is raised.
bool invert_blocks(const Schur& schur, LinearSolver& inner, std::span<const InverseRequest> requests,
                   const StopToken& stop);

}  // namespace boxplus
