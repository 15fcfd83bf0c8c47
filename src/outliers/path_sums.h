// SPDX-License-Identifier: BSD-3-Clause
// The uncertainty that accumulates along a path of poses.
#pragma once

#include "outliers/pose_graph.h"

namespace boxplus::outliers {

/// Sums over the steps of a path. A step adds the variance of its translation. An error of its rotation also
/// moves the rest of the path: at distance d from the step, it adds d² times the variance of the rotation.
/// With these sums, the uncertainty of the position of any point takes O(1). The sums of a part of a path are
/// differences of sums.
struct PathSums {
  double translation = 0;                    ///< Σ σ_t²
  double rotation = 0;                       ///< Σ σ_r²
  Vector3 rotation_first = Vector3::Zero();  ///< Σ σ_r² p, where p is the position after the step
  double rotation_second = 0;                ///< Σ σ_r² |p|²

  void add(const Spread& step, const Vector3& position) {
    translation += step.translation;
    rotation += step.rotation;
    rotation_first += step.rotation * position;
    rotation_second += step.rotation * position.squaredNorm();
  }
  PathSums operator+(const PathSums& other) const {
    return {translation + other.translation, rotation + other.rotation, rotation_first + other.rotation_first,
            rotation_second + other.rotation_second};
  }
  PathSums operator-(const PathSums& other) const {
    return {translation - other.translation, rotation - other.rotation, rotation_first - other.rotation_first,
            rotation_second - other.rotation_second};
  }

  /// The spread of the motion along the path, where `point` is the position that the rotations displace. The
  /// sums are never negative, except by rounding errors.
  Spread spread_at(const Vector3& point) const {
    const double levers = rotation_second - 2 * point.dot(rotation_first) + point.squaredNorm() * rotation;
    return {std::max(0.0, translation) + std::max(0.0, levers), std::max(0.0, rotation)};
  }
};

}  // namespace boxplus::outliers
