// SPDX-License-Identifier: BSD-3-Clause
// From relaxed rotations back to rotations.
#pragma once

#include <optional>

#include "optimize/initial_guess/frame_math.h"

namespace boxplus::guess {

/// The R in SO(d) that is nearest to M in the Frobenius norm (Umeyama 1991, lemma): with M = U S Vᵀ, R = U D
/// Vᵀ where D = diag(1, …, 1, det(U) det(V)). Empty where it is not unique: M has less than d − 1 singular
/// values above zero, or is a reflection whose two smallest are equal.
std::optional<SmallMatrix> nearest_rotation(const SmallMatrix& m);

}  // namespace boxplus::guess
