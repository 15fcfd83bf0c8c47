// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_PLANE3D_H_
#define G2O_PLANE3D_H_

#include <cmath>

#include "g2o/core/eigen_types.h"
#include "g2o/stuff/misc.h"
#include "g2o/types/slam3d_addons/g2o_types_slam3d_addons_api.h"

namespace g2o {

/// The plane n·x + d = 0 with |n| = 1. The coefficients (n, d) are stored. The distance from the origin to
/// the plane, along n, is −d.
class G2O_TYPES_SLAM3D_ADDONS_API Plane3D {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  /// The plane x = 1.
  Plane3D() : _coeffs(1, 0, 0, -1) {}
  Plane3D(const Vector4& v) {
    fromVector(v);
  }  // NOLINT(google-explicit-constructor): clients rely on the implicit conversion

  const Vector4& coeffs() const { return _coeffs; }
  Vector4 toVector() const { return _coeffs; }
  /// Sets the coefficients, scaled to |n| = 1.
  void fromVector(const Vector4& coeffs) {
    _coeffs = coeffs;
    normalize(_coeffs);
  }

  /// The azimuth (about z, from the x-axis) and the elevation (above the xy-plane) of a direction.
  static double azimuth(const Vector3& v) { return std::atan2(v[1], v[0]); }
  static double elevation(const Vector3& v) { return std::atan2(v[2], v.head<2>().norm()); }

  double distance() const { return -_coeffs[3]; }
  Vector3 normal() const { return _coeffs.head<3>(); }

  /// The rotation that turns the x-axis to the direction v: Rz(azimuth) Ry(−elevation).
  static Matrix3 rotation(const Vector3& v) {
    return (AngleAxis(azimuth(v), Vector3::UnitZ()) * AngleAxis(-elevation(v), Vector3::UnitY()))
        .toRotationMatrix();
  }

  /// Turns the normal by azimuth v[0] and elevation v[1], in the frame rotation(normal()). Adds v[2] to the
  /// distance.
  void oplus(const Vector3& v);

  /// Returns the azimuth and the elevation of the other plane's normal in the frame rotation(normal()), and
  /// the distance of this plane minus the distance of the other plane.
  Vector3 ominus(const Plane3D& plane) const;

 protected:
  static void normalize(Vector4& coeffs) { coeffs *= 1 / coeffs.head<3>().norm(); }

  Vector4 _coeffs;
};

/// Moves the plane by the motion t.
inline Plane3D operator*(const Isometry3& t, const Plane3D& plane) {
  Vector4 v;
  v.head<3>() = t.linear() * plane.normal();
  v[3] = plane.coeffs()[3] - t.translation().dot(v.head<3>());
  return Plane3D(v);
}

}  // namespace g2o

#endif  // G2O_PLANE3D_H_
