// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SBACAM_H
#define G2O_SBACAM_H

#include "g2o/types/sba/g2o_types_sba_api.h"
#include "g2o/types/slam3d/se3quat.h"

namespace g2o {

/// The pose of a camera in the world, its camera matrix, and the baseline (meters) to a second camera on its
/// right.
class G2O_TYPES_SBA_API SBACam : public SE3Quat {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  SBACam();
  SBACam(const Quaternion& r, const Vector3& t);
  SBACam(const SE3Quat& p);  // NOLINT: clients rely on the implicit conversion

  /// Changes the pose (t, q) by the increment (Δt, q_v): adds Δt to t in the world frame, and multiplies q
  /// from the right by the quaternion (q_v, √(1 − |q_v|²)). If |q_v| ≥ 1, normalizes q_v first.
  void update(const Vector6& update);

  /// Set m to a 3×4 matrix that transforms points. transformW2F() transforms from the world frame to the
  /// frame of the pose (trans, qrot), and transformF2W() transforms back.
  static void transformW2F(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot);
  static void transformF2W(Eigen::Matrix<double, 3, 4>& m, const Vector3& trans, const Quaternion& qrot);

  void setKcam(double fx, double fy, double cx, double cy, double tx);

  /// Each function updates members that depend on the pose and the camera matrix. setTransform() updates w2n,
  /// setProjection() updates w2i, and setDr() updates dRdx, dRdy and dRdz.
  void setTransform();
  void setProjection();
  void setDr();

  Matrix3 Kcam;
  double baseline;
  Eigen::Matrix<double, 3, 4> w2n;  ///< matrix from the world frame to the camera frame
  Eigen::Matrix<double, 3, 4> w2i;  ///< matrix from the world frame to the image
  Matrix3 dRdx, dRdy, dRdz;         ///< derivatives of the rotation in w2n by increments of qx, qy, qz
};

G2O_TYPES_SBA_API std::ostream& operator<<(std::ostream& os, const SBACam& cam);

}  // namespace g2o

#endif  // G2O_SBACAM_H
