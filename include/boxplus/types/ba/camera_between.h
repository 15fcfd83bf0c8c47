// SPDX-License-Identifier: BSD-3-Clause
// The relative measurement between two stereo cameras.
#pragma once

#include <string_view>

#include "boxplus/types/ba/stereo_camera.h"
#include "boxplus/types/between.h"

namespace boxplus {

/// z measures the pose of b relative to a. Error: that of Between<SE3> of the poses. The tag in g2o files is
/// EDGE_CAM.
struct CameraBetween {
  static constexpr std::string_view kName = "CameraBetween";
  static constexpr bool kJacobiansForSomeTypes = true;
  static constexpr bool kRigid = true;
  SE3 measurement;

  explicit CameraBetween(const SE3& z) : measurement(z) {}

  template <class S>
  Vector<S, 6> error(const BasicStereoPose<S>& a, const BasicStereoPose<S>& b) const {
    return Between<SE3>(measurement).error(a.pose, b.pose);
  }

  template <class A, class B>
  void jacobians(const StereoPose& a, const StereoPose& b, A& J_a, B& J_b) const {
    detail::between_jacobians(measurement, a.pose, b.pose, J_a, J_b);
  }

  detail::RelativeFrame relative_frame(const StereoPose&, const StereoPose&) const {
    return detail::relative_pose(0, 1, measurement);
  }
};

}  // namespace boxplus
