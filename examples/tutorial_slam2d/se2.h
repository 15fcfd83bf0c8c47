// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "g2o/core/eigen_types.h"
#include "g2o/stuff/misc.h"

namespace g2o {
namespace tutorial {

// [se2]
/// A rigid motion of the plane: a rotation by θ (radians), then a translation (meters).
class SE2 {
 public:
  SE2() : _R(0), _t(0, 0) {}
  SE2(double x, double y, double theta) : _R(theta), _t(x, y) {}

  /// The composition ⊕. The product transforms a point by the other motion first, and then by this motion.
  SE2 operator*(const SE2& other) const {
    SE2 product;
    product._t = _t + _R * other._t;
    product._R.angle() = normalize_theta(_R.angle() + other._R.angle());
    return product;
  }
  /// Transforms a point by this motion.
  Vector2 operator*(const Vector2& point) const { return _t + _R * point; }

  SE2 inverse() const {
    SE2 inverted;
    inverted._R.angle() = normalize_theta(-_R.angle());
    inverted._t = -(inverted._R * _t);
    return inverted;
  }

  const Vector2& translation() const { return _t; }
  const Rotation2D& rotation() const { return _R; }

  void fromVector(const Vector3& v) { *this = SE2(v[0], v[1], v[2]); }
  Vector3 toVector() const { return {_t.x(), _t.y(), _R.angle()}; }

 protected:
  Rotation2D _R;
  Vector2 _t;
};
// [/se2]

}  // namespace tutorial
}  // namespace g2o
