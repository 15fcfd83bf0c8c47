// SPDX-License-Identifier: BSD-3-Clause
// A scan of a laser range finder, which .g2o files list after the pose of the laser (io/data.h).
#pragma once

#include <string_view>

#include "boxplus/io/laser_scan.h"
#include "boxplus/io/robot_stamp.h"

namespace boxplus {

/// A line RAWLASER1 of CARMEN's logs: a scan without the pose of the robot. The frame of the laser is that of
/// the vertex to which the line belongs.
struct RawLaser : LaserScan {
  static constexpr std::string_view kTag = "RAWLASER1";
  RobotStamp stamp = {};

  /// Reads the fields after the tag. Throws InputError if a field is missing or no finite number, or if there
  /// are more fields.
  static RawLaser read(FieldReader& in);
  /// Writes the fields after the tag. Throws InvalidArgument if a number is not finite, or the host is not
  /// one word.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
