// SPDX-License-Identifier: BSD-3-Clause
// The projection of relaxed rotations onto rotations.
#pragma once

#include <optional>

#include "guess/frame_math.h"

namespace boxplus::guess {

/// The rotation R in SO(d) that is nearest to M in the Frobenius norm (Umeyama 1991, lemma). With M = U S Vᵀ
/// and D = diag(1, …, 1, det(U) det(V)), it is R = U D Vᵀ. The result is empty if R is not unique. This is
/// the case if M has fewer than d − 1 nonzero singular values, or if det(M) < 0 and the two smallest singular
/// values are equal.
std::optional<SmallMatrix> nearest_rotation(const SmallMatrix& m);

}  // namespace boxplus::guess
