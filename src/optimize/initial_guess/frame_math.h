// SPDX-License-Identifier: BSD-3-Clause
// Frames as rigid motions.
#pragma once

#include "boxplus/base/matrix.h"
#include "boxplus/graph/frame.h"

namespace boxplus::guess {

/// At most 3 × 3, without heap memory.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::DontAlign, 4, 4>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::DontAlign, 4, 1>;

/// The rotation of a frame, or the identity.
SmallMatrix rotation_of(const Frame& frame);
SmallVector translation_of(const Frame& frame);
void set_rotation(Frame& frame, const SmallMatrix& rotation);
void set_translation(Frame& frame, const SmallVector& translation);

/// The origin of the world, as a pose.
Frame world_frame(int dimension);
/// A · B; a point if B has no rotation.
Frame compose(const Frame& a, const Frame& b);
/// A · B⁻¹ for poses A and B.
Frame compose_with_inverse(const Frame& a, const Frame& b);
bool is_finite(const Frame& frame);

}  // namespace boxplus::guess
