// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "boxplus/types/slam2d/calibrate_drive.h"
#include "g2o/stuff/logger.h"
#include "g2o/types/sclam2d/closed_form_calibration.h"
#include "types/sclam2d/adapters_sclam2d.h"

namespace g2o {

VelocityMeasurement OdomConvert::convertToVelocity(const MotionMeasurement& m) {
  if (!(m.dt() > 0)) {
    G2O_ERROR("convertToVelocity(): expected dt > 0, got {}", m.dt());
    return VelocityMeasurement(0, 0, m.dt());
  }
  return adapters::to_g2o(boxplus::wheel_speeds(boxplus::SE2(m.x(), m.y(), m.theta()), m.dt()));
}

MotionMeasurement OdomConvert::convertToMotion(const VelocityMeasurement& v, double l) {
  const boxplus::SE2 motion =
      boxplus::WheelOdometry(adapters::speeds(v)).motion(boxplus::DifferentialDrive{1, 1, l});
  return MotionMeasurement(motion.x(), motion.y(), (v.vr() - v.vl()) * v.dt() / l, v.dt());
}

bool ClosedFormCalibration::calibrate(const MotionInformationVector& measurements, SE2& laserOffset,
                                      Vector3& odomParams) {
  try {
    std::vector<boxplus::DriveMotion> motions;
    for (const MotionInformation& m : measurements)
      motions.push_back({boxplus::wheel_speeds(adapters::pose(m.odomMotion), m.timeInterval),
                         adapters::pose(m.laserMotion)});
    const auto found = boxplus::calibrate_drive(motions);
    if (!found) return false;
    laserOffset = adapters::to_g2o(found->mount);
    odomParams = adapters::to_g2o(found->drive);
    return true;
  } catch (const boxplus::InvalidArgument& error) {
    G2O_ERROR("{}", error.what());
    return false;
  }
}

}  // namespace g2o
