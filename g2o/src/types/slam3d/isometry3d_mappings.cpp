// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/types/slam3d/isometry3d_mappings.h"

#include <cmath>

#include "boxplus/manifold/se3.h"

namespace g2o {
namespace internal {
namespace {

boxplus::SE3 engine_pose(const Isometry3& t) {
  return {boxplus::Vector3(t.translation()), boxplus::Matrix<double, 3, 3>(t.linear())};
}

Isometry3 to_g2o(const boxplus::SE3& x) {
  Isometry3 t = Isometry3::Identity();
  t.linear() = x.rotation();
  t.translation() = x.translation();
  return t;
}

}  // namespace

Quaternion normalized(const Quaternion& q) {
  Quaternion copy(q);
  return normalize(copy);
}

Quaternion& normalize(Quaternion& q) {
  q.normalize();
  if (q.w() < 0) q.coeffs() *= -1;
  return q;
}

Vector3 toEuler(const Matrix3& R) {
  const double horizontal = std::hypot(R(0, 0), R(1, 0));
  const double pitch = std::atan2(-R(2, 0), horizontal);
  if (horizontal < 1e-12) return {std::atan2(-R(1, 2), R(1, 1)), pitch, 0};
  return {std::atan2(R(2, 1), R(2, 2)), pitch, std::atan2(R(1, 0), R(0, 0))};
}

Matrix3 fromEuler(const Vector3& v) {
  return (AngleAxis(v[2], Vector3::UnitZ()) * AngleAxis(v[1], Vector3::UnitY()) *
          AngleAxis(v[0], Vector3::UnitX()))
      .toRotationMatrix();
}

Vector3 toCompactQuaternion(const Matrix3& R) {
  return boxplus::SO3(boxplus::Matrix<double, 3, 3>(R)).minimal();
}

Matrix3 fromCompactQuaternion(const Vector3& v) {
  return boxplus::detail::rotation_matrix(boxplus::detail::QuaternionChart::exp(v[0], v[1], v[2]));
}

Vector6 toVectorMQT(const Isometry3& t) {
  return engine_pose(t).minimal();
}

Vector6 toVectorET(const Isometry3& t) {
  Vector6 v;
  v << t.translation(), toEuler(t.linear());
  return v;
}

Vector7 toVectorQT(const Isometry3& t) {
  return engine_pose(t).vector();
}

Isometry3 fromVectorMQT(const Vector6& v) {
  return to_g2o(boxplus::SE3::from_minimal(v));
}

Isometry3 fromVectorET(const Vector6& v) {
  Isometry3 t = Isometry3::Identity();
  t.linear() = fromEuler(v.tail<3>());
  t.translation() = v.head<3>();
  return t;
}

Isometry3 fromVectorQT(const Vector7& v) {
  return to_g2o(boxplus::SE3::from_vector(v));
}

SE3Quat toSE3Quat(const Isometry3& t) {
  return SE3Quat(Matrix3(t.linear()), Vector3(t.translation()));
}

Isometry3 fromSE3Quat(const SE3Quat& t) {
  return t;
}

}  // namespace internal
}  // namespace g2o
