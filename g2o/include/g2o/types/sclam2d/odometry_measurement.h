// SPDX-License-Identifier: BSD-3-Clause
// The odometry of a robot with two driven wheels, as speeds of the wheels or as the motion of the robot.
#pragma once
#ifndef G2O_ODOMETRY_MEASUREMENT_H
#define G2O_ODOMETRY_MEASUREMENT_H

#include "g2o/core/eigen_types.h"
#include "g2o/types/sclam2d/g2o_types_sclam2d_api.h"

namespace g2o {

/// The speeds of the left and right wheel (meters per second), which stay constant for dt seconds.
class G2O_TYPES_SCLAM2D_API VelocityMeasurement {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  VelocityMeasurement() : _measurement(0, 0), _dt(0) {}
  VelocityMeasurement(double vl, double vr, double dt) : _measurement(vl, vr), _dt(dt) {}

  double vl() const { return _measurement[0]; }
  void setVl(double v) { _measurement[0] = v; }
  double vr() const { return _measurement[1]; }
  void setVr(double v) { _measurement[1] = v; }
  double dt() const { return _dt; }
  void setDt(double t) { _dt = t; }
  /// (vl, vr).
  const Vector2& measurement() const { return _measurement; }

 protected:
  Vector2 _measurement;
  double _dt;
};

/// The motion x, y (meters), θ (radians) of the robot in dt seconds.
class G2O_TYPES_SCLAM2D_API MotionMeasurement {
 public:
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  MotionMeasurement() : _measurement(0, 0, 0), _dt(0) {}
  MotionMeasurement(double x, double y, double theta, double dt) : _measurement(x, y, theta), _dt(dt) {}
  MotionMeasurement(const Vector3& m, double dt) : _measurement(m), _dt(dt) {}

  double x() const { return _measurement[0]; }
  void setX(double v) { _measurement[0] = v; }
  double y() const { return _measurement[1]; }
  void setY(double v) { _measurement[1] = v; }
  double theta() const { return _measurement[2]; }
  void setTheta(double v) { _measurement[2] = v; }
  double dt() const { return _dt; }
  void setDt(double t) { _dt = t; }
  /// (x, y, θ).
  const Vector3& measurement() const { return _measurement; }

 protected:
  Vector3 _measurement;
  double _dt;
};

/// Converts between speeds of the wheels and motions along an arc.
class G2O_TYPES_SCLAM2D_API OdomConvert {
 public:
  /// The speeds of wheels with the distance 1 m. If no arc with this θ ends at (x, y), the arc ends at the
  /// nearest position. If dt is not positive, the speeds are zero.
  static VelocityMeasurement convertToVelocity(const MotionMeasurement& m);
  /// The motion of a robot whose wheels have the distance l (meters). θ is not wrapped.
  static MotionMeasurement convertToMotion(const VelocityMeasurement& v, double l = 1.0);
};

}  // namespace g2o

#endif  // G2O_ODOMETRY_MEASUREMENT_H
