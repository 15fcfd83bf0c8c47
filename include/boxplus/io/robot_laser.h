// SPDX-License-Identifier: BSD-3-Clause
// A scan of a laser range finder, which .g2o files list after the pose of the robot (io/data.h).
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "boxplus/io/laser_scan.h"
#include "boxplus/io/robot_stamp.h"
#include "boxplus/manifold/se2.h"

namespace boxplus {

/// A line ROBOTLASER1 of CARMEN's logs: a laser scan with the odometry poses of the robot and of the laser.
/// Lengths are in meters, angles in radians, speeds in meters and radians per second.
struct RobotLaser : LaserScan {
  static constexpr std::string_view kTag = "ROBOTLASER1";

  // Poses in the frame of the odometry, as (x, y, θ). They keep the bits of the file.
  std::array<double, 3> laser_pose{};  ///< T_odometry_laser
  std::array<double, 3> robot_pose{};  ///< T_odometry_robot
  double translational_velocity = 0, rotational_velocity = 0;
  double forward_safety_distance = 0, side_safety_distance = 0;
  double turn_axis = 0;
  RobotStamp stamp = {};

  /// The place of the laser on the robot: T_robot_laser = T_odometry_robot⁻¹ · T_odometry_laser.
  SE2 T_robot_laser() const;
  /// The points of end_points() in the frame of the robot, which is that of the vertex to which the line
  /// belongs.
  std::vector<Vector<double, 2>> end_points_of_robot() const;

  /// Reads the fields after the tag. Throws InputError if a field is missing or no finite number, or if there
  /// are more fields.
  static RobotLaser read(FieldReader& in);
  /// Writes the fields after the tag. Throws InvalidArgument if a number is not finite, or the host is not
  /// one word.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
