// SPDX-License-Identifier: BSD-3-Clause
// Adapters from the cameras of the g2o API to those of the engine (boxplus/types/ba): the images of points in
// the frame of a camera, and the derivatives of the images.
#pragma once

#include "boxplus/types/ba/stereo_camera.h"
#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/se3_ops.h"

namespace g2o {
namespace adapters {

/// A pinhole camera, and bf, the baseline of a stereo pair times fx.
using Pinhole = boxplus::detail::StereoPinhole<double>;

inline Pinhole pinhole(double fx, double fy, double cx, double cy, double bf = 0) {
  return {boxplus::PinholeCamera(fx, fy, cx, cy), bf};
}

/// The derivatives of the image of a point in the frame of the camera.
template <int Rows>
using ImageDerivatives = boxplus::detail::ImageDerivatives<Rows>;

/// The derivatives of −image(T x) by x, and by a step T ← exp(ω, υ) T. The step changes the pose X = T⁻¹ of
/// the engine to X exp(−ω, −υ).
template <int Rows, class A>
void negative_by_point(const ImageDerivatives<Rows>& by, const Quaternion& rotation, A& J) {
  by.by_rotated_point(-rotation.toRotationMatrix(), J);
}
template <int Rows, class A>
[[gnu::always_inline]] inline void negative_by_step(const ImageDerivatives<Rows>& by, A& J) {
  by.by_pose(J.template rightCols<3>(), J.template leftCols<3>());
}

inline Matrix3 camera_matrix(double fx, double fy, double cx, double cy) {
  Matrix3 K;
  K << fx, 0, cx, 0, fy, cy, 0, 0, 1;
  return K;
}

/// Computes the derivatives of R, the rotation from the world to a camera, with respect to q_v, the vector
/// part of a quaternion that rotates the pose of the camera. The factor is −2, because (q_v, 1) rotates by 2
/// q_v, and R is the rotation of the inverse pose.
inline void rotation_derivatives(const Matrix3& R, Matrix3& dRdx, Matrix3& dRdy, Matrix3& dRdz) {
  dRdx = -2 * skew(Vector3::UnitX()) * R;
  dRdy = -2 * skew(Vector3::UnitY()) * R;
  dRdz = -2 * skew(Vector3::UnitZ()) * R;
}

/// The image for a camera matrix K, and its derivatives. Clients may set any entry of K, also those that no
/// camera of the engine has, such as a skew. But the image of p is that of K p in a camera whose matrix is
/// the identity.
template <int Rows>
Eigen::Matrix<double, Rows, 1> image(const Matrix3& K, double bf, const Vector3& p) {
  return pinhole(1, 1, 0, 0, bf).image<Rows>(K * p);
}
template <int Rows>
Eigen::Matrix<double, Rows, 3> image_by_point(const Matrix3& K, double bf, const Vector3& p) {
  return ImageDerivatives<Rows>(pinhole(1, 1, 0, 0, bf), K * p).by_point() * K;
}

}  // namespace adapters
}  // namespace g2o
