// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#ifndef G2O_RAW_LASER_H
#define G2O_RAW_LASER_H

#include <vector>

#include "g2o/core/eigen_types.h"
#include "g2o/types/data/laser_parameters.h"
#include "g2o/types/data/robot_data.h"

namespace g2o {

/// A scan of a laser range finder. Tag: RAWLASER1. read() and write() use all fields of the rest of a line.
/// (g2o has no tag for this type, and cannot write it.)
class G2O_TYPES_DATA_API RawLaser : public RobotData {
 public:
  using Point2DVector = std::vector<Vector2>;

  EIGEN_MAKE_ALIGNED_OPERATOR_NEW
  RawLaser();
  ~RawLaser() override;

  bool read(std::istream& is) override;
  bool write(std::ostream& os) const override;

  /// The points that the beams have hit, in the frame of the laser. Ranges that are not positive or not
  /// smaller than the maximum range have no point.
  Point2DVector cartesian() const;

  const std::vector<double>& ranges() const { return _ranges; }
  void setRanges(const std::vector<double>& ranges) { _ranges = ranges; }

  const std::vector<double>& remissions() const { return _remissions; }
  void setRemissions(const std::vector<double>& remissions) { _remissions = remissions; }

  const LaserParameters& laserParams() const { return _laserParams; }
  void setLaserParams(const LaserParameters& laserParams) { _laserParams = laserParams; }

 protected:
  std::vector<double> _ranges;
  std::vector<double> _remissions;
  LaserParameters _laserParams;
};

}  // namespace g2o

#endif  // G2O_RAW_LASER_H
