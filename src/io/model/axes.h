// SPDX-License-Identifier: BSD-3-Clause
// The axes of BAL's cameras and of all others.
#pragma once

#include "boxplus/manifold/se3.h"

namespace boxplus {

/// The pose of a BAL camera, which looks along −z and whose y points up, from the pose of the same camera
/// with z forward and y down; or the other way around.
inline SE3 with_turned_axes(const SE3& T_world_camera) {
  constexpr detail::Quaternion<double> kHalfTurnAboutX{1, 0, 0, 0};
  return SE3::from_unit(T_world_camera.translation(), T_world_camera.quaternion() * kHalfTurnAboutX);
}

}  // namespace boxplus
