// SPDX-License-Identifier: BSD-3-Clause
// Images of points in cameras, and the derivatives of the images with respect to the point p. An image is the
// first two rows of K p divided by the third row.
//
// For cameras without skew, there are faster functions in closed form, and also derivatives with respect to a
// motion of p, because visual SLAM projects and differentiates its points in every iteration.
#pragma once

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/se3_ops.h"

namespace g2o {
namespace formulas {

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

/// Returns (u, v, u − bf/depth). The third value is the u of the point in a second camera on the right.
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

/// Computes the derivatives of R, the rotation from the world to a camera, with respect to q_v, the vector
/// part of a quaternion that rotates the pose of the camera. The factor is −2, because (q_v, 1) rotates by 2
/// q_v, and R is the rotation of the inverse pose.
inline void rotation_derivatives(const Matrix3& R, Matrix3& dRdx, Matrix3& dRdy, Matrix3& dRdz) {
  dRdx = -2 * skew(Vector3::UnitX()) * R;
  dRdy = -2 * skew(Vector3::UnitY()) * R;
  dRdz = -2 * skew(Vector3::UnitZ()) * R;
}

/// A camera without skew: u = fx x/z + cx, v = fy y/z + cy.
struct Pinhole {
  double fx, fy, cx, cy;
};

inline Vector2 image(const Pinhole& camera, const Vector3& p) {
  const double inverse = 1 / p[2];
  return {camera.fx * p[0] * inverse + camera.cx, camera.fy * p[1] * inverse + camera.cy};
}
inline Vector3 stereo_image(const Pinhole& camera, double bf, const Vector3& p) {
  const double inverse = 1 / p[2], u = camera.fx * p[0] * inverse + camera.cx;
  return {u, camera.fy * p[1] * inverse + camera.cy, u - bf * inverse};
}

inline Eigen::Matrix<double, 2, 3> image_jacobian(const Pinhole& camera, const Vector3& p) {
  const double inverse = 1 / p[2], a = camera.fx * inverse, b = camera.fy * inverse;
  Eigen::Matrix<double, 2, 3> J;
  J << a, 0, -a * p[0] * inverse, 0, b, -b * p[1] * inverse;
  return J;
}
inline Matrix3 stereo_image_jacobian(const Pinhole& camera, double bf, const Vector3& p) {
  Matrix3 J;
  J.topRows<2>() = image_jacobian(camera, p);
  J.row(2) = J.row(0);
  J(2, 2) += bf / (p[2] * p[2]);
  return J;
}

/// The derivatives of the image of exp(δ) p with respect to δ = (ω, υ) at δ = 0: D [−[p]×, I], with D from
/// image_jacobian().
/// The overload with three arguments stores them without a temporary matrix: a processor waits if it loads
/// several values at once that were just stored one by one.
template <class Jacobian>
void image_by_motion(const Pinhole& camera, const Vector3& p, Jacobian& J) {
  const double inverse = 1 / p[2], x = p[0] * inverse, y = p[1] * inverse;
  const double a = camera.fx * inverse, b = camera.fy * inverse;
  J(0, 0) = -camera.fx * x * y;
  J(1, 0) = -camera.fy * (1 + y * y);
  J(0, 1) = camera.fx * (1 + x * x);
  J(1, 1) = camera.fy * x * y;
  J(0, 2) = -camera.fx * y;
  J(1, 2) = camera.fy * x;
  J(0, 3) = a;
  J(1, 3) = 0;
  J(0, 4) = 0;
  J(1, 4) = b;
  J(0, 5) = -a * x;
  J(1, 5) = -b * y;
}
inline Eigen::Matrix<double, 2, 6> image_by_motion(const Pinhole& camera, const Vector3& p) {
  Eigen::Matrix<double, 2, 6> J;
  image_by_motion(camera, p, J);
  return J;
}
/// The derivatives of the image of R x + t with respect to x, for p = R x + t.
template <class Jacobian>
void image_by_rotated_point(const Pinhole& camera, const Vector3& p, const Matrix3& R, Jacobian& J) {
  const double inverse = 1 / p[2], a = camera.fx * inverse, b = camera.fy * inverse;
  const double x = p[0] * inverse, y = p[1] * inverse;
  for (int j = 0; j < 3; ++j) {
    J(0, j) = a * (R(0, j) - x * R(2, j));
    J(1, j) = b * (R(1, j) - y * R(2, j));
  }
}
inline Eigen::Matrix<double, 3, 6> stereo_image_by_motion(const Pinhole& camera, double bf,
                                                          const Vector3& p) {
  const double disparity_rate = bf / (p[2] * p[2]);  // derivative of u − bf/depth with respect to the depth
  Eigen::Matrix<double, 3, 6> J;
  J.topRows<2>() = image_by_motion(camera, p);
  J.row(2) = J.row(0);
  J(2, 0) += disparity_rate * p[1];
  J(2, 1) -= disparity_rate * p[0];
  J(2, 5) += disparity_rate;
  return J;
}

}  // namespace formulas
}  // namespace g2o
