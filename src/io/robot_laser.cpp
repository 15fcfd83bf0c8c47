// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/robot_laser.h"

#include "io/data_fields.h"

namespace boxplus {
namespace {

SE2 pose_of(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

SE2 RobotLaser::T_robot_laser() const {
  return pose_of(robot_pose).inverse() * pose_of(laser_pose);
}

std::vector<Vector<double, 2>> RobotLaser::end_points_of_robot() const {
  const SE2 T = T_robot_laser();
  std::vector<Vector<double, 2>> points = end_points();
  for (Vector<double, 2>& point : points) point = T * point;
  return points;
}

RobotLaser RobotLaser::read(FieldReader& in) {
  RobotLaser laser{LaserScan::read(in)};
  in.numbers(laser.laser_pose.data(), 3, "the pose of the laser");
  in.numbers(laser.robot_pose.data(), 3, "the pose of the robot");
  laser.translational_velocity = in.number("a translational velocity");
  laser.rotational_velocity = in.number("a rotational velocity");
  laser.forward_safety_distance = in.number("a safety distance");
  laser.side_safety_distance = in.number("a safety distance");
  laser.turn_axis = in.number("a turn axis");
  laser.stamp = RobotStamp::read(in);
  in.expect_end();
  return laser;
}

void RobotLaser::write(FieldWriter& out) const {
  LaserScan::write(out);
  write_finite(out, laser_pose);
  write_finite(out, robot_pose);
  write_finite(out, std::array{translational_velocity, rotational_velocity, forward_safety_distance,
                               side_safety_distance, turn_axis});
  stamp.write(out);
}

}  // namespace boxplus
