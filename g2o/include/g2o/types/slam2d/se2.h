// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_SE2_H_
#define G2O_SE2_H_

#include "g2o/core/eigen_types.h"
#include "g2o/stuff/misc.h"
#include "g2o/types/slam2d/g2o_types_slam2d_api.h"

namespace g2o {

/// A rigid motion of the plane: x, y (meters) and θ (radians).
class SE2 {
 public:
  SE2() : _R(0), _t(0, 0) {}
  // Older clients rely on these implicit conversions.
  SE2(const Isometry2& iso) : _R(0), _t(iso.translation()) {  // NOLINT
    _R.fromRotationMatrix(iso.linear());
  }
  SE2(const Vector3& v) : _R(v[2]), _t(v[0], v[1]) {}  // NOLINT
  SE2(double x, double y, double theta) : _R(theta), _t(x, y) {}

  const Vector2& translation() const { return _t; }
  void setTranslation(const Vector2& t) { _t = t; }
  const Rotation2D& rotation() const { return _R; }
  void setRotation(const Rotation2D& R) { _R = R; }

  /// Returns the composition of two motions. It applies `other` first.
  SE2 operator*(const SE2& other) const {
    SE2 product(*this);
    product *= other;
    return product;
  }
  SE2& operator*=(const SE2& other) {
    _t += _R * other._t;
    _R.angle() = normalize_theta(_R.angle() + other._R.angle());
    return *this;
  }
  Vector2 operator*(const Vector2& v) const { return _t + _R * v; }
  SE2 inverse() const {
    SE2 inverted;
    inverted._R.angle() = normalize_theta(-_R.angle());
    inverted._t = inverted._R * Vector2(-_t);
    return inverted;
  }

  double operator[](int i) const { return i < 2 ? _t(i) : _R.angle(); }
  /// Convert from and to the vector (x, y, θ).
  void fromVector(const Vector3& v) { *this = SE2(v[0], v[1], v[2]); }
  Vector3 toVector() const { return Vector3(_t.x(), _t.y(), _R.angle()); }

  Isometry2 toIsometry() const {
    Isometry2 iso = Isometry2::Identity();
    iso.linear() = _R.toRotationMatrix();
    iso.translation() = _t;
    return iso;
  }
  void fromIsometry(const Isometry2& iso) { *this = SE2(iso); }

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

 protected:
  Rotation2D _R;
  Vector2 _t;
};

namespace internal {

template <class E>
struct KeptMeasurement;

/// A measured motion and its inverse (see ReadyMadeEdge).
template <>
struct KeptMeasurement<SE2> {
  SE2 _inverseMeasurement;
  void keep(const SE2& m) { _inverseMeasurement = m.inverse(); }
};

}  // namespace internal
}  // namespace g2o

#endif  // G2O_SE2_H_
