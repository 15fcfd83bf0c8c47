// SPDX-License-Identifier: BSD-3-Clause
// The parameters of two driven wheels and the pose of a sensor on the robot, computed in closed form from
// measured motions: the start of a calibration with WheelOdometry and OffsetBetween<SE2>.
#pragma once

#include <optional>
#include <span>

#include "boxplus/manifold/se2.h"
#include "boxplus/types/slam2d/wheel_odometry.h"

namespace boxplus {

/// What the wheels and the sensor measured between two times.
struct DriveMotion {
  WheelSpeeds wheels;
  /// The motion of the sensor (meters, radians): its second pose in the frame of its first pose. The sensor
  /// must turn by less than π, because the pose cannot express more; this is not checked.
  SE2 sensor;
};

struct DriveCalibration {
  DifferentialDrive drive;
  SE2 mount;  ///< the pose of the sensor on the robot
};

/// Fits the drive and the mount to measured motions in two linear least squares problems (Censi, Franchi,
/// Marchionni & Oriolo, "Simultaneous calibration of odometry and sensor parameters for mobile robots", IEEE
/// Transactions on Robotics 29(2), 2013): first the ratios factor/baseline to the rotations, then the
/// baseline and the mount to the translations. Needs no initial guess. All motions have the same weight, and
/// outliers have full influence. Exact if the measurements are exact.
///
/// Returns nothing if the motions do not determine all parameters: if both wheels always have the same ratio
/// of speeds, as on a straight line, on a single circle or in turns on the spot. Throws InvalidArgument if a
/// number is not finite. Takes linear time.
std::optional<DriveCalibration> calibrate_drive(std::span<const DriveMotion> motions);

/// The speeds at which a drive moves along an arc for a duration > 0 (seconds), to the position and heading
/// of `motion`. If no arc of this heading ends at the position, the arc ends at the nearest position. This is
/// the inverse of WheelOdometry::motion(), and converts an odometry that is given as poses. Throws
/// InvalidArgument if the duration is not positive.
WheelSpeeds wheel_speeds(const SE2& motion, double duration, const DifferentialDrive& drive = {});

}  // namespace boxplus
