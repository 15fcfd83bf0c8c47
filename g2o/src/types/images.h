// SPDX-License-Identifier: BSD-3-Clause
// The images of points in cameras: the first two rows of K p over its third, and their derivatives by p.
#pragma once

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/se3_ops.h"

namespace g2o {
namespace native {

inline Matrix3 camera_matrix(double fx, double fy, double cx, double cy) {
  Matrix3 K;
  K << fx, 0, cx, 0, fy, cy, 0, 0, 1;
  return K;
}

inline Vector2 image(const Matrix3& K, const Vector3& p) {
  const Vector3 h = K * p;
  return h.head<2>() / h[2];
}
inline Eigen::Matrix<double, 2, 3> image_jacobian(const Matrix3& K, const Vector3& p) {
  return (K.topRows<2>() - image(K, p) * K.row(2)) / K.row(2).dot(p);
}

/// u, v, and u in a second camera at the right, u − bf/depth.
inline Vector3 stereo_image(const Matrix3& K, double bf, const Vector3& p) {
  const Vector2 left = image(K, p);
  return {left[0], left[1], left[0] - bf / p[2]};
}
inline Matrix3 stereo_image_jacobian(const Matrix3& K, double bf, const Vector3& p) {
  Matrix3 J;
  J.topRows<2>() = image_jacobian(K, p);
  J.row(2) = J.row(0);
  J(2, 2) += bf / (p[2] * p[2]);
  return J;
}

/// Derivatives of a camera's rotation R from the world by the vector part q_v of a quaternion that turns its
/// pose: (q_v, 1) turns by 2 q_v, and R is the rotation of the inverse pose.
inline void rotation_derivatives(const Matrix3& R, Matrix3& dRdx, Matrix3& dRdy, Matrix3& dRdz) {
  dRdx = -2 * skew(Vector3::UnitX()) * R;
  dRdy = -2 * skew(Vector3::UnitY()) * R;
  dRdz = -2 * skew(Vector3::UnitZ()) * R;
}

}  // namespace native
}  // namespace g2o
