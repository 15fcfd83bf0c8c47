// SPDX-License-Identifier: BSD-3-Clause
// The class SE2 that a reader writes from listing 3 of the g2o document.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "g2o/stuff/misc.h"

namespace manual {

using Eigen::Rotation2Dd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using g2o::normalize_theta;

class SE2 {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  SE2() : _R(0), _t(0, 0) {}
  SE2(double x, double y, double theta) : _R(theta), _t(x, y) {}

  SE2 operator*(const SE2& other) const {
    SE2 product(*this);
    product._t += _R * other._t;
    product._R.angle() = normalize_theta(_R.angle() + other._R.angle());
    return product;
  }
  Vector2d operator*(const Vector2d& point) const { return _t + _R * point; }
  SE2 inverse() const {
    SE2 inverted;
    inverted._R.angle() = normalize_theta(-_R.angle());
    inverted._t = inverted._R * Vector2d(-_t);
    return inverted;
  }
  double operator[](int i) const { return i < 2 ? _t(i) : _R.angle(); }
  void fromVector(const Vector3d& v) { *this = SE2(v[0], v[1], v[2]); }
  Vector3d toVector() const { return Vector3d((*this)[0], (*this)[1], (*this)[2]); }

 protected:
  Rotation2Dd _R;
  Vector2d _t;
};

}  // namespace manual
