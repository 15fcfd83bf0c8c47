// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LINE2D_H
#define G2O_LINE2D_H

#include <cmath>

#include "g2o/core/eigen_types.h"
#include "g2o/stuff/misc.h"
#include "g2o/types/slam2d/se2.h"
#include "g2o/types/slam2d_addons/g2o_types_slam2d_addons_api.h"

namespace g2o {

/// The points p with n·p = ρ, where n = (cos θ, sin θ). The entries are θ (radians) and ρ (meters).
struct Line2D : public Vector2 {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  Line2D() : Vector2(0, 0) {}
  // Clients rely on these implicit conversions.
  template <class Derived>
  Line2D(const Eigen::MatrixBase<Derived>& v) : Vector2(v) {}  // NOLINT
};

/// Moves the line by the motion t.
inline Line2D operator*(const SE2& t, const Line2D& line) {
  const double theta = normalize_theta(line[0] + t.rotation().angle());
  return Line2D(Vector2(theta, line[1] + Vector2(std::cos(theta), std::sin(theta)).dot(t.translation())));
}

}  // namespace g2o

#endif  // G2O_LINE2D_H
