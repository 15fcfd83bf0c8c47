// SPDX-License-Identifier: BSD-3-Clause
// Rigid motions in space. Motions of the plane are motions in space that keep z.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/frame.h"

namespace boxplus::outliers {

struct Motion {
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 translation = Vector3::Zero();

  Motion operator*(const Motion& other) const {
    return {rotation * other.rotation, rotation * other.translation + translation};
  }
  Motion inverse() const { return {rotation.transpose(), -(rotation.transpose() * translation)}; }
  /// this⁻¹ · other
  Motion inverse_times(const Motion& other) const {
    return {rotation.transpose() * other.rotation, rotation.transpose() * (other.translation - translation)};
  }
  /// The squared angle of the rotation.
  double squared_angle() const {
    const Vector3 twice_axis(rotation(2, 1) - rotation(1, 2), rotation(0, 2) - rotation(2, 0),
                             rotation(1, 0) - rotation(0, 1));
    const double angle = std::atan2(twice_axis.norm() / 2, (rotation.trace() - 1) / 2);
    return angle * angle;
  }
};

inline Motion motion_of(const detail::Frame& frame) {
  Motion motion;
  const int d = frame.dimension;
  for (int i = 0; i < d; ++i) {
    motion.translation[i] = frame.translation[i];
    for (int j = 0; j < d; ++j) motion.rotation(i, j) = frame.rotation[i * d + j];
  }
  return motion;
}

}  // namespace boxplus::outliers
