// SPDX-License-Identifier: BSD-3-Clause
// Blocks of the inverse of H from blocks of the inverse of its Schur complement.
#pragma once

#include <span>

#include "linear/column_inverse.h"
#include "linear/schur/schur.h"

namespace boxplus {

/// `inner` has factorized the damped Schur complement S. With Y = W (V + λD)⁻¹, (H + λD)⁻¹ = [(V + λD)⁻¹ + Yᵀ
/// S⁻¹ Y, −Yᵀ S⁻¹; −S⁻¹ Y, S⁻¹]. Fills the requests. Calls `inner` once, for all blocks of S⁻¹ that are
/// needed: an eliminated block needs those of the kept blocks that it is joined with. Returns false if
/// `inner` cannot do this, or if `stop` is raised.
bool invert_blocks(const Schur& schur, LinearSolver& inner, std::span<const InverseRequest> requests,
                   const StopToken& stop);

}  // namespace boxplus
