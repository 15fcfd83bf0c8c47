// SPDX-License-Identifier: BSD-3-Clause
// Measurements by a sensor whose clock differs from the clock of the poses by an unknown offset.
#pragma once

#include <type_traits>
#include <utility>

#include "boxplus/types/pose_math.h"
#include "boxplus/types/type_label.h"

namespace boxplus {

namespace detail {
struct TimeShiftedText {
  static constexpr std::string_view kText = "TimeShifted";
};

/// The pose after δ seconds of constant velocity v (m/s, in the world) and constant angular velocity ω
/// (rad/s, in the frame of the body): (p + v δ, R Exp(ω δ)).
template <class S, class Chart>
BasicSE3<S, Chart> moved(const BasicSE3<S, Chart>& pose, const Vector<S, 3>& velocity, const Vector3& omega,
                         const S& seconds) {
  const Quaternion<S> turn =
      RotationVectorChart::exp(S(omega[0] * seconds), S(omega[1] * seconds), S(omega[2] * seconds));
  return BasicSE3<S, Chart>::from_unit(pose.translation() + velocity * seconds, pose.quaternion() * turn);
}
}  // namespace detail

/// The measurement of the edge E was made δ seconds after the time of its poses, because the clock of the
/// sensor is late by δ, or because the sensor has a delay of −δ. Error: that of E for the poses that move
/// with their velocities for δ. Accelerations are neglected, so the error of a position is up to ½ a δ².
///
/// E is an edge of one pose (SE3 or SE3RotationVector, T_world_body) and other vertices that do not move,
/// such as Reprojection, PointObservation3 or OffsetPositionPrior; or an edge of two poses, such as Between.
/// Vertices:
///   X, v, δ, …           pose, velocity (Vector3, m/s, in the world), offset (double, s), the others of E
///   X_i, v_i, X_j, v_j, δ
/// The angular velocities (rad/s, in the frame of the body) are those that a gyroscope measures at the times
/// of the poses, minus its bias.
template <class E>
struct TimeShifted {
  static constexpr std::string_view kName = detail::TypeLabel<detail::TimeShiftedText, E>::kValue;
  E edge;
  Vector3 angular_velocity;                     ///< at the time of the (first) pose
  Vector3 second_angular_velocity = {0, 0, 0};  ///< at the time of the second pose, if there is one

  TimeShifted(E shifted, const Vector3& omega) : edge(std::move(shifted)), angular_velocity(omega) {}
  TimeShifted(E shifted, const Vector3& omega_i, const Vector3& omega_j)
      : edge(std::move(shifted)), angular_velocity(omega_i), second_angular_velocity(omega_j) {}

  template <class S, class Chart, class... Rest>
  auto error(const BasicSE3<S, Chart>& pose, const Vector<S, 3>& velocity, const S& offset,
             const Rest&... rest) const {
    return edge.error(detail::moved(pose, velocity, angular_velocity, offset), rest...);
  }
  template <class S, class Chart>
  auto error(const BasicSE3<S, Chart>& pose_i, const Vector<S, 3>& velocity_i,
             const BasicSE3<S, Chart>& pose_j, const Vector<S, 3>& velocity_j, const S& offset) const {
    return edge.error(detail::moved(pose_i, velocity_i, angular_velocity, offset),
                      detail::moved(pose_j, velocity_j, second_angular_velocity, offset));
  }
};

}  // namespace boxplus
