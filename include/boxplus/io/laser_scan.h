// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/io/field_reader.h"

namespace boxplus {

/// One turn of a laser range finder: the fields that the lines RAWLASER1 and ROBOTLASER1 of CARMEN's logs
/// have in common. Beam k measures the distance ranges[k] in the direction first_beam + k · angular_step of
/// the laser's frame. Lengths are in meters, angles in radians.
struct LaserScan {
  std::int64_t type = 0;  ///< of the sensor, in CARMEN's numbering
  double first_beam = 0;  ///< the angle of beam 0
  double field_of_view = 0;
  double angular_step = 0;  ///< between neighboring beams
  double max_range = 0;     ///< a range that is not smaller means that the beam has hit nothing
  double accuracy = 0;
  std::int64_t remission_mode = 0;
  std::vector<double> ranges;
  std::vector<double> remissions;  ///< intensities of the reflections; may have another size than ranges

  /// The points that the beams have hit, in the frame of the laser: r (cos α, sin α) for each beam with the
  /// range r and the direction α, if 0 < r < max_range.
  std::vector<Vector<double, 2>> end_points() const;

  /// Reads these fields. Throws InputError if a field is missing or no finite number. The memory is
  /// proportional to the length of the line, whatever its counts say.
  static LaserScan read(FieldReader& in);
  /// Throws InvalidArgument if a number is not finite.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
