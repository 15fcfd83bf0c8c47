// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINE3D_H_
#define G2O_LINE3D_H_

#include "g2o/core/eigen_types.h"
#include "g2o/stuff/misc.h"
#include "g2o/types/slam3d_addons/g2o_types_slam3d_addons_api.h"

namespace g2o {

/// The orthonormal representation of a line (Bartoli and Sturm 2005): U = [w/|w|, d/|d|, (w × d)/|w × d|] and
/// W = [cos φ, −sin φ; sin φ, cos φ], where φ = atan2(|d|, |w|).
struct OrthonormalLine3D {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  Matrix2 W = Matrix2::Identity();
  Matrix3 U = Matrix3::Identity();
};

/// A line in Plücker coordinates: the moment w = p × d for each point p on the line, then the direction d ≠
/// 0.
class G2O_TYPES_SLAM3D_ADDONS_API Line3D : public Vector6 {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  /// The x-axis.
  Line3D() { *this << 0, 0, 0, 1, 0, 0; }
  Line3D(const Vector6& v)
      : Vector6(v) {}  // NOLINT(google-explicit-constructor): clients rely on the implicit conversion

  Vector3 w() const { return head<3>(); }
  Vector3 d() const { return tail<3>(); }
  void setW(const Vector3& w) { head<3>() = w; }
  void setD(const Vector3& d) { tail<3>() = d; }

  /// From a point on the line, and a direction of any length but zero.
  static Line3D fromCartesian(const Vector6& line);
  /// The point of the line that is nearest to the origin, and a unit direction.
  Vector6 toCartesian() const;
  static Line3D fromOrthonormal(const OrthonormalLine3D& line);
  static OrthonormalLine3D toOrthonormal(const Line3D& line);

  /// Scales the coordinates to |d| = 1.
  void normalize() { *this *= 1 / d().norm(); }
  Line3D normalized() const {
    Line3D result = *this;
    result.normalize();
    return result;
  }

  /// Turns U by the quaternion with the vector part (v[0], v[1], v[2]) from the right, and adds v[3] to φ.
  void oplus(const Vector4& v);
  /// Returns the v with which oplus() turns this line into the other line.
  Vector4 ominus(const Line3D& line) const;
};

/// Moves the line by the motion t.
G2O_TYPES_SLAM3D_ADDONS_API Line3D operator*(const Isometry3& t, const Line3D& line);

namespace internal {

/// Moves a line that consists of a point and a direction.
inline Vector6 transformCartesianLine(const Isometry3& t, const Vector6& line) {
  Vector6 moved;
  moved << t * Vector3(line.head<3>()), t.linear() * line.tail<3>();
  return moved;
}

/// The same line, with the point that is nearest to the origin, and a unit direction.
inline Vector6 normalizeCartesianLine(const Vector6& line) {
  const Vector3 p = line.head<3>(), d = line.tail<3>().normalized();
  Vector6 result;
  result << p - d.dot(p) * d, d;
  return result;
}

}  // namespace internal
}  // namespace g2o

#endif  // G2O_LINE3D_H_
