// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_MATH_STUFF
#define G2O_MATH_STUFF

#include "g2o/core/eigen_types.h"

namespace g2o {

/// [v]×, the matrix of the cross product with v.
inline Matrix3 skew(const Vector3& v) {
  Matrix3 m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

/// The vector v with [v]× = R − Rᵀ. It is 2 sin(angle) times the rotation axis.
inline Vector3 deltaR(const Matrix3& R) {
  return Vector3(R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1));
}

/// project() converts from homogeneous coordinates, and unproject() converts to homogeneous coordinates.
inline Vector2 project(const Vector3& v) {
  return v.head<2>() / v[2];
}
inline Vector3 project(const Vector4& v) {
  return v.head<3>() / v[3];
}
inline Vector3 unproject(const Vector2& v) {
  return Vector3(v[0], v[1], 1);
}
inline Vector4 unproject(const Vector3& v) {
  return Vector4(v[0], v[1], v[2], 1);
}

}  // namespace g2o

#endif  // G2O_MATH_STUFF
