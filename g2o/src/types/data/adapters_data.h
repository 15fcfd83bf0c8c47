// SPDX-License-Identifier: BSD-3-Clause
// Conversions between the data of the g2o API and the data of the engine (boxplus/io/data.h).
#pragma once

#include <limits>
#include <string>

#include "boxplus/io/data.h"
#include "g2o/core/factory.h"
#include "g2o/stuff/logger.h"
#include "g2o/types/data/raw_laser.h"
#include "types/adapters.h"

G2O_USE_TYPE_GROUP(data)  // registers the tags for clients that use only these types

namespace g2o {
namespace adapters {

/// Reads data of the engine from the rest of a line, and passes it to `take`. If the fields are invalid,
/// reports an error message and returns false.
template <class T, class Take>
bool read_data(std::istream& is, Take&& take) {
  std::string text;
  if (!std::getline(is, text)) return false;
  try {
    boxplus::FieldReader in("", 1, text);
    take(T::read(in));
    return true;
  } catch (const boxplus::InputError& error) {
    internal::complain(is, without_place("", error));
  } catch (const boxplus::Error& error) {
    internal::complain(is, error.what());
  }
  return false;
}

/// Writes data of the engine. If it cannot be written, reports an error message and returns false.
template <class T>
bool write_data(std::ostream& os, const T& data) {
  try {
    return write_fields(os, [&](boxplus::FieldWriter& out) { data.write(out); });
  } catch (const boxplus::Error& error) {
    G2O_ERROR("{}", error.what());
    return false;
  }
}

inline void take_stamp(const boxplus::RobotStamp& stamp, RobotData& data) {
  data.setTimestamp(stamp.timestamp);
  data.setHostname(stamp.host);
  data.setLoggerTimestamp(stamp.logger_timestamp);
}
inline boxplus::RobotStamp stamp_of(const RobotData& data) {
  return {data.timestamp(), data.hostname(), data.loggerTimestamp()};
}

/// Sets all of a laser but its pose. Throws boxplus::InvalidArgument if a number does not fit an int.
void take_scan(const boxplus::LaserScan& scan, RawLaser& laser);
boxplus::LaserScan scan_of(const RawLaser& laser);

/// Throws boxplus::InvalidArgument if the value is too large for a float.
float to_float(double value);
/// The number to write for a float: the number of the file from which the float was made, or otherwise the
/// shortest one that becomes this float.
double number_of(float value, double of_file = std::numeric_limits<double>::quiet_NaN());

}  // namespace adapters
}  // namespace g2o
