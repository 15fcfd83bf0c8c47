// SPDX-License-Identifier: BSD-3-Clause
// The direction of a point in the plane, seen from a pose.
#pragma once

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the angle (radians) to the point l in the frame of the pose X. Error: wrap(z − atan2(X⁻¹ l)).
/// The tag in g2o files is EDGE_BEARING_SE2_XY.
struct BearingObservation2 {
  static constexpr std::string_view kName = "BearingObservation2";
  double measurement;

  explicit BearingObservation2(double z) : measurement(z) {}

  template <class S, class Point>
  S error(const BasicSE2<S>& pose, const Point& point) const {
    using std::atan2;
    const auto b = pose.inverse_times(point);
    return detail::normalize_angle(S(measurement - atan2(b[1], b[0])));
  }
};

}  // namespace boxplus
