// SPDX-License-Identifier: BSD-3-Clause
// Odometry of two driven wheels whose parameters are calibrated along with the trajectory.
#pragma once

#include "boxplus/types/pose_math.h"
#include "boxplus/types/slam2d/differential_drive.h"

namespace boxplus {

/// Wheel speeds v_l, v_r (meters per second) that stay constant for the duration dt (seconds).
struct WheelSpeeds {
  double left = 0, right = 0, duration = 0;
};

/// z measures the wheel speeds during the motion from xi to xj. Error: (x, y, θ) of U⁻¹ xi⁻¹ xj. The motion U
/// is the arc that wheels with the parameters k drive at these speeds (Dudek & Jenkin, "Computational
/// Principles of Mobile Robotics", 2000):
///     U = (s sin θ / θ, s (1 − cos θ) / θ, θ),   θ = (r − l) dt / baseline,   s = (r + l) dt / 2,
/// with the corrected speeds l = k_l v_l and r = k_r v_r.
/// Vertices: xi, xj, k. The tag in g2o files is EDGE_SE2_ODOM_DIFFERENTIAL_CALIB.
struct WheelOdometry {
  static constexpr std::string_view kName = "WheelOdometry";
  WheelSpeeds measurement;

  explicit WheelOdometry(const WheelSpeeds& z) : measurement(z) {}

  template <class S>
  BasicSE2<S> motion(const BasicDifferentialDrive<S>& k) const {
    using std::cos;
    using std::sin;
    const S l = k.left_factor * measurement.left, r = k.right_factor * measurement.right;
    const S theta = (r - l) * measurement.duration / k.baseline;
    const S arc = 0.5 * (r + l) * measurement.duration;
    const S t = theta * theta;
    if (t < S(detail::kSmallSquaredAngle)) {
      const S along = 1.0 - t * (1.0 / 6.0 - t * (1.0 / 120.0 - t * (1.0 / 5040.0)));
      const S across = theta * (0.5 - t * (1.0 / 24.0 - t * (1.0 / 720.0 - t * (1.0 / 40320.0))));
      return {S(arc * along), S(arc * across), theta};
    }
    return {S(arc * sin(theta) / theta), S(arc * (1.0 - cos(theta)) / theta), theta};
  }

  template <class S>
  Vector<S, 3> error(const BasicSE2<S>& xi, const BasicSE2<S>& xj, const BasicDifferentialDrive<S>& k) const {
    return motion(k).inverse_times(xi.inverse_times(xj)).vector();
  }

  detail::RelativeFrame relative_frame(const SE2&, const SE2&, const DifferentialDrive& k) const {
    return detail::relative_pose(0, 1, motion(k));
  }
};

}  // namespace boxplus
