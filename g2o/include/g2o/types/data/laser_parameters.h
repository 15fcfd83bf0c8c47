// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_LASER_PARAMETERS_H
#define G2O_LASER_PARAMETERS_H

#include "g2o/types/data/g2o_types_data_api.h"
#include "g2o/types/slam2d/se2.h"

namespace g2o {

/// The parameters of a laser range finder. Lengths are in meters, angles in radians.
struct G2O_TYPES_DATA_API LaserParameters {
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  /// The field of view is `beams` · `angularStep`.
  LaserParameters(int type, int beams, double firstBeamAngle, double angularStep, double maxRange,
                  double accuracy, int remissionMode);
  /// A laser of type 0 with an accuracy of 0.1 m, and without remissions.
  LaserParameters(int beams, double firstBeamAngle, double angularStep, double maxRange);

  SE2 laserPose;  ///< T_robot_laser
  int type;
  double firstBeamAngle;
  double fov;
  double angularStep;  ///< between neighboring beams
  double accuracy;
  int remissionMode;
  double maxRange;  ///< a range that is not smaller means that the beam has hit nothing
};

}  // namespace g2o

#endif  // G2O_LASER_PARAMETERS_H
