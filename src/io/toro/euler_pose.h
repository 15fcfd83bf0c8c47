// SPDX-License-Identifier: BSD-3-Clause
// Poses in space with roll, pitch and yaw, as in the files of TORO and iSAM.
#pragma once

#include <cmath>

#include "boxplus/io/field_reader.h"
#include "boxplus/manifold/se3.h"

namespace boxplus {

/// Reads x y z roll pitch yaw (meters, radians). The rotation is Rz(yaw) Ry(pitch) Rx(roll).
inline SE3 read_euler_pose(FieldReader& in) {
  Vector3 t;
  in.numbers(t.data(), 3, "a coordinate");
  const double roll = in.number("the roll angle") / 2, pitch = in.number("the pitch angle") / 2,
               yaw = in.number("the yaw angle") / 2;
  const double cr = std::cos(roll), sr = std::sin(roll), cp = std::cos(pitch), sp = std::sin(pitch),
               cy = std::cos(yaw), sy = std::sin(yaw);
  return SE3(t, detail::Quaternion<double>{cy * cp * sr - sy * sp * cr, cy * sp * cr + sy * cp * sr,
                                           sy * cp * cr - cy * sp * sr, cy * cp * cr + sy * sp * sr});
}

/// Writes x y z roll pitch yaw. The angles are computed one after the other, so that they together are the
/// rotation also where pitch = ±π/2, where roll and yaw are not unique.
inline void write_euler_pose(const SE3& pose, FieldWriter& out) {
  for (int i = 0; i < 3; ++i) out.number(pose.translation()[i]);
  const Matrix<double, 3, 3> R = pose.rotation();
  const double yaw = std::atan2(R(1, 0), R(0, 0)), c = std::cos(yaw), s = std::sin(yaw);
  const double pitch = std::atan2(-R(2, 0), c * R(0, 0) + s * R(1, 0));
  const double roll = std::atan2(s * R(0, 2) - c * R(1, 2), c * R(1, 1) - s * R(0, 1));
  for (const double angle : {roll, pitch, yaw}) out.number(angle + 0.0);  // no negative zero
}

/// The vector part of a quaternion is half of a small angle. So the row of a rotation in Ω, in the order x y
/// z roll pitch yaw, is multiplied by 2 for an edge of boxplus, whose error is (t, q_v).
inline double euler_row_scale(int row) {
  return row < 3 ? 1 : 2;
}

}  // namespace boxplus
