// SPDX-License-Identifier: BSD-3-Clause
// The projection of relaxed rotations onto rotations.
#pragma once

#include <optional>

#include "optimize/initial_guess/frame_math.h"

namespace boxplus::guess {

/// The R in SO(d) that is nearest to M in the Frobenius norm (Umeyama 1991, lemma): with M = U S Vᵀ and D =
/// diag(1, …, 1, det(U) det(V)), R = U D Vᵀ. Empty if it is not unique, because M has fewer than d − 1
/// nonzero singular values, or is a reflection whose two smallest singular values are equal.
std::optional<SmallMatrix> nearest_rotation(const SmallMatrix& m);

}  // namespace boxplus::guess
