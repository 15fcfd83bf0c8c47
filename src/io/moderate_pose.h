// SPDX-License-Identifier: BSD-3-Clause
// The poses of cameras that files may have.
#pragma once

#include "boxplus/manifold/se3.h"

namespace boxplus {

/// Whether the pose is finite and squared distances from it do not overflow. Readers refuse all others, and
/// writers do not write them.
inline bool is_moderate(const SE3& pose) {
  constexpr double kMostDistant = 1e150;
  return pose.vector().allFinite() && pose.translation().cwiseAbs().maxCoeff() < kMostDistant;
}

}  // namespace boxplus
