// SPDX-License-Identifier: BSD-3-Clause
// Logs of CARMEN (Montemerlo, Roy and Thrun, "Perspectives on standardization in mobile robot programming:
// The Carnegie Mellon navigation (CARMEN) toolkit", 2003). A line is a message of a robot: a name, its
// contents, and a stamp (the time of the measurement, a host, the time of the record). These messages are
// used:
//
//     ODOM x y θ tv rv acceleration STAMP
//     FLASER n r₁ … rₙ  x y θ of the laser  x y θ of the robot  STAMP     (RLASER: the laser at the back)
//     ROBOTLASER1, RAWLASER1                                              (io/robot_laser.h, io/raw_laser.h)
//     ROBOTLASER2 … ROBOTLASER5: other lasers of the robot; they are kept as ROBOTLASER1, which has the pose
//     of its laser
//
// The format is read-only.
#pragma once

#include <cstddef>

#include "boxplus/io/file_format.h"
#include "boxplus/manifold/se2.h"

namespace boxplus {

/// Poses of the robot become vertices SE2, which are the poses of the odometry. Successive poses are joined
/// by an edge Between<SE2>. A message with the same pose as the one before belongs to the same vertex. Scans
/// are kept as lines of data (io/data.h) after their vertex.
FileFormat carmen_format();

/// Ω of the motion between two poses. A log has no covariances; these are assumed: the standard deviations
/// are 0.01 m + 5 % of the distance along both axes, and 0.005 rad + 5 % of the rotation + 0.02 rad per meter
/// for the heading.
Information odometry_information(const SE2& motion);

/// The directions of the beams of a FLASER or RLASER, which lists only their number.
struct AssumedBeams {
  double first = 0, field_of_view = 0, step = 0;  ///< radians
};
/// The lasers of these logs (SICK LMS 200) scan 180°, or 100° with 101, 201 or 401 beams. The beams lie
/// symmetrically around the forward direction. An even number of beams lacks the last one.
AssumedBeams assumed_beams(std::size_t count);

}  // namespace boxplus
