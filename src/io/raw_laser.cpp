// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/raw_laser.h"

namespace boxplus {

RawLaser RawLaser::read(FieldReader& in) {
  RawLaser laser{LaserScan::read(in)};
  laser.stamp = RobotStamp::read(in);
  in.expect_end();
  return laser;
}

void RawLaser::write(FieldWriter& out) const {
  LaserScan::write(out);
  stamp.write(out);
}

}  // namespace boxplus
