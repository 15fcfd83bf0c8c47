// SPDX-License-Identifier: BSD-3-Clause
// Poses at the origin that are turned.
#pragma once

#include "boxplus/types/slam3d.h"

namespace boxplus {

/// The pose that is turned by the rotation vector (rx, ry, rz).
inline SE3 turned(double rx, double ry, double rz) {
  return SE3::from_unit(Vector3(0, 0, 0), detail::RotationVectorChart::exp(rx, ry, rz));
}

/// The pose that is turned by `angle` about the unit vector `axis`.
inline SE3 turned(const Vector3& axis, double angle) {
  return turned(axis[0] * angle, axis[1] * angle, axis[2] * angle);
}

}  // namespace boxplus
