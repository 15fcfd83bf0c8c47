// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/types/slam3d/surface_match.h"

#include <Eigen/Geometry>

namespace boxplus {

Matrix<double, 3, 3> detail::frame_of_normal(const Vector3& normal) {
  constexpr double kMinSine = 1e-3;
  const Vector3 y(0, 1, 0);
  const bool is_parallel = normal.cross(y).norm() < kMinSine * normal.norm();
  const Vector3 axis = is_parallel ? Vector3(1, 0, 0) : y;
  const Vector3 a = (axis - axis.dot(normal) * normal).normalized();
  Matrix<double, 3, 3> F;
  F.row(0) = normal.cross(a);
  F.row(1) = a;
  F.row(2) = normal;
  return F;
}

}  // namespace boxplus
