// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_ROBOT_LASER_H
#define G2O_ROBOT_LASER_H

#include "g2o/core/hyper_graph_action.h"
#include "g2o/types/data/raw_laser.h"
#include "g2o/types/slam2d/se2.h"

namespace g2o {

/// A laser scan with the odometry pose of the robot. Tag: ROBOTLASER1. read() and write() use all fields
/// after the tag. laserParams().laserPose is the pose of the laser in the frame of the robot.
class G2O_TYPES_DATA_API RobotLaser : public RawLaser {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  RobotLaser();
  ~RobotLaser() override;

  bool read(std::istream& is) override;
  /// Values that have not changed since read() are written as they were read.
  bool write(std::ostream& os) const override;

  /// The pose of the laser in the frame of the odometry.
  SE2 laserPose() const { return _odomPose * _laserParams.laserPose; }
  /// The pose of the robot in the frame of the odometry.
  const SE2& odomPose() const { return _odomPose; }
  void setOdomPose(const SE2& odomPose) { _odomPose = odomPose; }

 protected:
  SE2 _odomPose;
  double _laserTv = 0, _laserRv = 0;  ///< the velocities of the robot
  double _forwardSafetyDist = 0, _sideSaftyDist = 0, _turnAxis = 0;

 private:
  /// The laser's pose in the file, and the values that it has led to.
  Vector3 _laserPoseOfFile, _odomPoseOfFile, _laserOnRobot;
};

/// The action "draw" of RobotLaser: the points that the beams have hit, if the data belongs to a pose. Its
/// properties are POINT_SIZE (pixels), BEAMS_DOWNSAMPLING (draws one beam out of so many) and MAX_RANGE
/// (draws smaller ranges only; if it is negative, the maximum range of the laser).
class G2O_TYPES_DATA_API RobotLaserDrawAction : public internal::NamedAction<DrawAction> {
 public:
  RobotLaserDrawAction();
};

}  // namespace g2o

#endif  // G2O_ROBOT_LASER_H
