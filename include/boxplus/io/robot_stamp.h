// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "boxplus/io/field_reader.h"

namespace boxplus {

/// When and where a robot recorded data: the last three fields of the lines that CARMEN's logs have in common
/// with .g2o files. All times are in seconds.
struct RobotStamp {
  double timestamp = 0;         ///< of the measurement
  std::string host = "robot";   ///< the computer that measured; one word
  double logger_timestamp = 0;  ///< of the record

  /// Throws InputError if a field is missing or no finite number.
  static RobotStamp read(FieldReader& in);
  /// Throws InvalidArgument if the host is not one word.
  void write(FieldWriter& out) const;
};

}  // namespace boxplus
