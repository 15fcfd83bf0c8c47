// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/robot_stamp.h"

#include "io/data_fields.h"

namespace boxplus {

RobotStamp RobotStamp::read(FieldReader& in) {
  RobotStamp stamp;
  stamp.timestamp = in.number("the time of the measurement");
  stamp.host = in.token("the name of a computer");
  stamp.logger_timestamp = in.number("the time of the record");
  return stamp;
}

void RobotStamp::write(FieldWriter& out) const {
  write_finite(out, {&timestamp, 1});
  write_word(out, "the name of a computer", host);
  write_finite(out, {&logger_timestamp, 1});
}

}  // namespace boxplus
