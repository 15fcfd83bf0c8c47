// SPDX-License-Identifier: BSD-3-Clause
// Frames as rigid motions.
#pragma once

#include "boxplus/base/matrix.h"
#include "boxplus/graph/frame.h"

namespace boxplus::guess {

/// Matrices and vectors of at most 4 × 4 values, which use no heap memory.
using SmallMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::DontAlign, 4, 4>;
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::DontAlign, 4, 1>;

/// The rotation of a frame, or the identity if the frame is a point, which has no rotation.
SmallMatrix rotation_of(const detail::Frame& frame);
SmallVector translation_of(const detail::Frame& frame);
void set_rotation(detail::Frame& frame, const SmallMatrix& rotation);
void set_translation(detail::Frame& frame, const SmallVector& translation);

/// The origin of the world, as a pose.
detail::Frame world_frame(int dimension);
/// A · B. The result is a point if B has no rotation.
detail::Frame compose(const detail::Frame& a, const detail::Frame& b);
/// A · B⁻¹ for poses A and B.
detail::Frame compose_with_inverse(const detail::Frame& a, const detail::Frame& b);
bool is_finite(const detail::Frame& frame);

}  // namespace boxplus::guess
