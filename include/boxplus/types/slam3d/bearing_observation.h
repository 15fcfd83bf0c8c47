// SPDX-License-Identifier: BSD-3-Clause
// The direction of a point in space, seen from a pose.
#pragma once

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the unit vector towards the point l in the frame of the pose X. Error: b/|b| − z with b = X⁻¹
/// l. The length of the error is the chord between the two directions, which is about the angle between them
/// if this angle is small. The error has no singular direction. The Jacobian has three rows, but rank two.
struct BearingObservation3 {
  static constexpr std::string_view kName = "BearingObservation3";
  Vector3 measurement;

  /// `direction` may have any length but zero.
  explicit BearingObservation3(const Vector3& direction) : measurement(direction.normalized()) {}

  template <class S, class Chart, class Point>
  Vector<S, 3> error(const BasicSE3<S, Chart>& pose, const Point& point) const {
    using std::sqrt;
    const Vector<S, 3> b = pose.inverse_times(point);
    const S length = sqrt(S(b[0] * b[0] + b[1] * b[1] + b[2] * b[2]));
    return b / length - measurement;
  }
};

}  // namespace boxplus
