// SPDX-License-Identifier: BSD-3-Clause
// The relative measurement between two poses, with the error of g2o's EDGE_SE3:EXPMAP.
#pragma once

#include <string_view>
#include <utility>

#include "boxplus/types/pose_math.h"

namespace boxplus {

/// z measures the pose b relative to the pose a. Error: (ω, υ) = log(b (a z)⁻¹), the constant angular and
/// linear velocity in the world frame that moves a z to b in one unit of time (radians, meters). The tag in
/// g2o files is EDGE_SE3:EXPMAP; its poses are SE3RotationVector.
struct TwistBetween {
  static constexpr std::string_view kName = "TwistBetween";
  static constexpr bool kRigid = true;
  SE3 measurement;

  explicit TwistBetween(const SE3& z) : measurement(z) {}

  template <class S, class Chart>
  Vector<S, 6> error(const BasicSE3<S, Chart>& a, const BasicSE3<S, Chart>& b) const {
    const auto z = BasicSE3<S, Chart>::from_unit(measurement.translation().template cast<S>(),
                                                 measurement.quaternion().template cast<S>());
    const Vector<S, 6> log = (b * (a * z).inverse()).log();
    Vector<S, 6> e;
    e << log.template tail<3>(), log.template head<3>();
    return e;
  }

  template <class Pose>
  detail::RelativeFrame relative_frame(const Pose&, const Pose&) const {
    detail::RelativeFrame relative = detail::relative_pose(0, 1, measurement);
    std::swap(relative.translation_row, relative.rotation_row);
    relative.rotation_unit = 1;
    return relative;
  }
};

}  // namespace boxplus
