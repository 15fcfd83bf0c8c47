// SPDX-License-Identifier: BSD-3-Clause
// The pose of a camera in a BAL file.
#pragma once

#include "boxplus/manifold/se3.h"

namespace boxplus {

/// The rotation vector and the translation of T_camera_world.
struct BalPose {
  Vector3 rotation, translation;

  BalPose(const Vector3& r, const Vector3& t) : rotation(r), translation(t) {}
  explicit BalPose(const SE3& T_world_camera) {
    const SE3 T_camera_world = T_world_camera.inverse();
    const Vector3 positive_zero(0, 0, 0);  // x + 0 is 0 also if x is −0
    rotation = T_camera_world.so3().rotation_vector() + positive_zero;
    translation = T_camera_world.translation() + positive_zero;
  }

  SE3 T_world_camera() const { return SE3(translation, SO3::from_rotation_vector(rotation)).inverse(); }
};

}  // namespace boxplus
