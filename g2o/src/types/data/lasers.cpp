// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "g2o/types/data/robot_laser.h"
#include "types/data/adapters_data.h"

namespace g2o {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

LaserParameters::LaserParameters(int laserType, int beams, double firstAngle, double step, double longest,
                                 double precision, int mode)
    : type(laserType),
      firstBeamAngle(firstAngle),
      fov(step * beams),
      angularStep(step),
      accuracy(precision),
      remissionMode(mode),
      maxRange(longest) {}

LaserParameters::LaserParameters(int beams, double firstAngle, double step, double longest)
    : LaserParameters(0, beams, firstAngle, step, longest, 0.1, 0) {}

RawLaser::RawLaser() : _laserParams(0, 180, -kPi / 2, kPi / 180, 50, 0.1, 0) {}
RawLaser::~RawLaser() = default;

bool RawLaser::read(std::istream& is) {
  return adapters::read_data<boxplus::RawLaser>(is, [&](const boxplus::RawLaser& laser) {
    adapters::take_scan(laser, *this);
    adapters::take_stamp(laser.stamp, *this);
  });
}

bool RawLaser::write(std::ostream& os) const {
  return adapters::write_data(os, boxplus::RawLaser{adapters::scan_of(*this), adapters::stamp_of(*this)});
}

RawLaser::Point2DVector RawLaser::cartesian() const {
  Point2DVector points;
  for (const auto& point : adapters::scan_of(*this).end_points()) points.emplace_back(point[0], point[1]);
  return points;
}

RobotLaser::RobotLaser()
    : _laserPoseOfFile(Vector3::Zero()), _odomPoseOfFile(Vector3::Zero()), _laserOnRobot(Vector3::Zero()) {}
RobotLaser::~RobotLaser() = default;

bool RobotLaser::read(std::istream& is) {
  return adapters::read_data<boxplus::RobotLaser>(is, [&](const boxplus::RobotLaser& laser) {
    adapters::take_scan(laser, *this);
    adapters::take_stamp(laser.stamp, *this);
    _laserPoseOfFile = Vector3(laser.laser_pose.data());
    _odomPoseOfFile = Vector3(laser.robot_pose.data());
    _odomPose = SE2(_odomPoseOfFile);
    _laserParams.laserPose = _odomPose.inverse() * SE2(_laserPoseOfFile);
    _laserOnRobot = _laserParams.laserPose.toVector();
    _laserTv = laser.translational_velocity;
    _laserRv = laser.rotational_velocity;
    _forwardSafetyDist = laser.forward_safety_distance;
    _sideSaftyDist = laser.side_safety_distance;
    _turnAxis = laser.turn_axis;
  });
}

bool RobotLaser::write(std::ostream& os) const {
  boxplus::RobotLaser laser{adapters::scan_of(*this)};
  const Vector3 robot = _odomPose.toVector();
  const bool is_of_file = robot == _odomPoseOfFile && _laserParams.laserPose.toVector() == _laserOnRobot;
  const Vector3 sensor = is_of_file ? _laserPoseOfFile : laserPose().toVector();
  std::copy_n(sensor.data(), 3, laser.laser_pose.begin());
  std::copy_n(robot.data(), 3, laser.robot_pose.begin());
  laser.translational_velocity = _laserTv;
  laser.rotational_velocity = _laserRv;
  laser.forward_safety_distance = _forwardSafetyDist;
  laser.side_safety_distance = _sideSaftyDist;
  laser.turn_axis = _turnAxis;
  laser.stamp = adapters::stamp_of(*this);
  return adapters::write_data(os, laser);
}

}  // namespace g2o
