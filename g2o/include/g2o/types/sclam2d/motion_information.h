// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_MOTION_INFORMATION_H
#define G2O_MOTION_INFORMATION_H

#include <vector>

#include "g2o/types/sclam2d/g2o_types_sclam2d_api.h"
#include "g2o/types/slam2d/se2.h"

namespace g2o {

/// What a laser scanner and the odometry of the robot measured between two times.
struct MotionInformation {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  SE2 laserMotion;          ///< the motion of the scanner, which turns by less than π
  SE2 odomMotion;           ///< the motion of the robot, if its wheels had the distance 1 m
  double timeInterval = 1;  ///< seconds
};

using MotionInformationVector = std::vector<MotionInformation, Eigen::aligned_allocator<MotionInformation>>;

}  // namespace g2o

#endif  // G2O_MOTION_INFORMATION_H
