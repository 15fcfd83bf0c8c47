// SPDX-License-Identifier: BSD-3-Clause
// A named place, which .g2o files list after a pose (io/data.h).
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "boxplus/io/robot_stamp.h"

namespace boxplus {

/// A line VERTEX_TAG of a .g2o file.
struct VertexTag {
  static constexpr std::string_view kTag = "VERTEX_TAG";

  std::string name = "tag";            ///< one word
  std::array<double, 3> position{};    ///< in meters, in the frame of the pose
  std::array<double, 3> robot_pose{};  ///< T_odometry_robot as (x, y, θ), in meters and radians
  RobotStamp stamp = {};

  /// Reads the fields after the tag. Throws InputError if a field is missing or no finite number, or if there
  /// are more fields.
  static VertexTag read(FieldReader& in);
  /// Writes the fields after the tag. Throws InvalidArgument if a number is not finite, or the name or the
  /// host is not one word.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
