// SPDX-License-Identifier: BSD-3-Clause
// Conversions between rigid motions and vectors.
#pragma once
#ifndef G2O_ISOMETRY3D_MAPPINGS_H_
#define G2O_ISOMETRY3D_MAPPINGS_H_

// clang-format off: this header comes first, because it sets the alignment of Eigen
#include "g2o/config.h"
// clang-format on

#include <Eigen/SVD>

#include "g2o/core/eigen_types.h"
#include "g2o/types/slam3d/g2o_types_slam3d_api.h"
#include "g2o/types/slam3d/se3quat.h"

namespace g2o {
namespace internal {

/// Returns the rotation matrix of a motion.
inline Isometry3::ConstLinearPart extractRotation(const Isometry3& A) {
  return A.linear();
}

/// Replaces R by the nearest rotation matrix. Uses a singular value decomposition.
template <typename Derived>
void nearestOrthogonalMatrix(const Eigen::MatrixBase<Derived>& R) {
  const Eigen::JacobiSVD<Matrix3> svd(R, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3 D = Matrix3::Identity();
  D(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const_cast<Eigen::MatrixBase<Derived>&>(R) = svd.matrixU() * D * svd.matrixV().transpose();
}
/// Approximates nearestOrthogonalMatrix() to first order, without a decomposition. R must be close to a
/// rotation.
template <typename Derived>
void approximateNearestOrthogonalMatrix(const Eigen::MatrixBase<Derived>& R) {
  Matrix3 E = R.transpose() * R;
  E.diagonal().array() -= 1;
  const_cast<Eigen::MatrixBase<Derived>&>(R) -= 0.5 * R * E;
}

/// Scale q to a unit quaternion with w ≥ 0.
G2O_TYPES_SLAM3D_API Quaternion normalized(const Quaternion& q);
G2O_TYPES_SLAM3D_API Quaternion& normalize(Quaternion& q);

/// Convert between a rotation matrix and (roll, pitch, yaw): R = Rz(yaw) Ry(pitch) Rx(roll).
G2O_TYPES_SLAM3D_API Vector3 toEuler(const Matrix3& R);
G2O_TYPES_SLAM3D_API Matrix3 fromEuler(const Vector3& v);
/// Convert between a rotation matrix and the vector part of its unit quaternion with w ≥ 0.
G2O_TYPES_SLAM3D_API Vector3 toCompactQuaternion(const Matrix3& R);
G2O_TYPES_SLAM3D_API Matrix3 fromCompactQuaternion(const Vector3& v);

/// Convert between a motion and a vector. The vector is the translation, followed by the compact quaternion
/// (MQT), the Euler angles (ET), or the quaternion x y z w (QT).
G2O_TYPES_SLAM3D_API Vector6 toVectorMQT(const Isometry3& t);
G2O_TYPES_SLAM3D_API Vector6 toVectorET(const Isometry3& t);
G2O_TYPES_SLAM3D_API Vector7 toVectorQT(const Isometry3& t);
G2O_TYPES_SLAM3D_API Isometry3 fromVectorMQT(const Vector6& v);
G2O_TYPES_SLAM3D_API Isometry3 fromVectorET(const Vector6& v);
G2O_TYPES_SLAM3D_API Isometry3 fromVectorQT(const Vector7& v);

G2O_TYPES_SLAM3D_API SE3Quat toSE3Quat(const Isometry3& t);
G2O_TYPES_SLAM3D_API Isometry3 fromSE3Quat(const SE3Quat& t);

}  // namespace internal
}  // namespace g2o

#endif  // G2O_ISOMETRY3D_MAPPINGS_H_
