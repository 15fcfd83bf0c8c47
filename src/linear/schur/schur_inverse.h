// SPDX-License-Identifier: BSD-3-Clause
// Computes blocks of the inverse of H from blocks of the inverse of its Schur complement.
#pragma once

#include <span>

#include "linear/column_inverse.h"
#include "linear/schur/schur.h"

namespace boxplus {

/// Computes the requested blocks of (H + λD)⁻¹. Let Y = W (V + λD)⁻¹, and let S be the damped Schur
/// complement, which `inner` must have factorized. Then
///   (H + λD)⁻¹ = [(V + λD)⁻¹ + Yᵀ S⁻¹ Y, −Yᵀ S⁻¹; −S⁻¹ Y, S⁻¹].
/// Calls `inner` once, for all required blocks of S⁻¹. An eliminated block requires the blocks of S⁻¹ for the
/// kept blocks that an edge joins with it. Returns false if `inner` cannot compute them, or if `stop` is
/// raised.
bool invert_blocks(const Schur& schur, LinearSolver& inner, std::span<const InverseRequest> requests,
                   const StopToken& stop);

}  // namespace boxplus
