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

/// The vector part of a quaternion is half of a small angle. So the row of a rotation in Ω, in the order x y
/// z roll pitch yaw, is multiplied by 2 for an edge of boxplus, whose error is (t, q_v).
inline double euler_row_scale(int row) {
  return row < 3 ? 1 : 2;
}

}  // namespace boxplus
