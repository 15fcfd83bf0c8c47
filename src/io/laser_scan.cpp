// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/laser_scan.h"

#include <array>
#include <cmath>

#include "io/data_fields.h"

namespace boxplus {

std::vector<Vector<double, 2>> LaserScan::end_points() const {
  std::vector<Vector<double, 2>> points;
  points.reserve(ranges.size());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const double r = ranges[k], angle = first_beam + static_cast<double>(k) * angular_step;
    if (r > 0 && r < max_range) points.emplace_back(r * std::cos(angle), r * std::sin(angle));
  }
  return points;
}

LaserScan LaserScan::read(FieldReader& in) {
  LaserScan scan;
  scan.type = in.integer("the type of a laser");
  scan.first_beam = in.number("the angle of the first beam");
  scan.field_of_view = in.number("a field of view");
  scan.angular_step = in.number("the angle between beams");
  scan.max_range = in.number("the largest range");
  scan.accuracy = in.number("the accuracy of ranges");
  scan.remission_mode = in.integer("a mode of remissions");
  scan.ranges = read_list(in, "the number of ranges", "a range");
  scan.remissions = read_list(in, "the number of remissions", "a remission");
  return scan;
}

void LaserScan::write(FieldWriter& out) const {
  out.integer(type);
  write_finite(out, std::array{first_beam, field_of_view, angular_step, max_range, accuracy});
  out.integer(remission_mode);
  write_list(out, ranges);
  write_list(out, remissions);
}

}  // namespace boxplus
