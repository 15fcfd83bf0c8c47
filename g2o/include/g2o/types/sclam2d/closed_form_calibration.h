// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_CLOSED_FORM_CALIBRATION_H
#define G2O_CLOSED_FORM_CALIBRATION_H

#include "g2o/types/sclam2d/motion_information.h"
#include "g2o/types/sclam2d/odometry_measurement.h"

namespace g2o {

/// Computes the parameters of two driven wheels and the pose of a laser scanner on the robot in closed form
/// (Censi, Franchi, Marchionni & Oriolo, "Simultaneous calibration of odometry and sensor parameters for
/// mobile robots", IEEE Transactions on Robotics 29(2), 2013).
class G2O_TYPES_SCLAM2D_API ClosedFormCalibration {
 public:
  /// `odomParams` has the factors on the speeds of the left and right wheel, and the distance between the
  /// wheels, as in VertexOdomDifferentialParams. Returns false and changes nothing if the motions do not
  /// determine all parameters, if a number is not finite, or if a timeInterval is not positive.
  static bool calibrate(const MotionInformationVector& measurements, SE2& laserOffset, Vector3& odomParams);
};

}  // namespace g2o

#endif  // G2O_CLOSED_FORM_CALIBRATION_H
