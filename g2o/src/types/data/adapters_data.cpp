// SPDX-License-Identifier: BSD-3-Clause
#include "types/data/adapters_data.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "base/number_from_chars.h"
#include "boxplus/base/error.h"

namespace g2o {
namespace adapters {
namespace {

int to_int(std::int64_t value) {
  if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max())
    throw boxplus::InvalidArgument("expected a number that fits an int, got " + std::to_string(value));
  return static_cast<int>(value);
}

}  // namespace

void take_scan(const boxplus::LaserScan& scan, RawLaser& laser) {
  LaserParameters parameters(to_int(scan.type), 0, scan.first_beam, scan.angular_step, scan.max_range,
                             scan.accuracy, to_int(scan.remission_mode));
  parameters.fov = scan.field_of_view;
  laser.setLaserParams(parameters);
  laser.setRanges(scan.ranges);
  laser.setRemissions(scan.remissions);
}

boxplus::LaserScan scan_of(const RawLaser& laser) {
  const LaserParameters& parameters = laser.laserParams();
  boxplus::LaserScan scan;
  scan.type = parameters.type;
  scan.first_beam = parameters.firstBeamAngle;
  scan.field_of_view = parameters.fov;
  scan.angular_step = parameters.angularStep;
  scan.max_range = parameters.maxRange;
  scan.accuracy = parameters.accuracy;
  scan.remission_mode = parameters.remissionMode;
  scan.ranges = laser.ranges();
  scan.remissions = laser.remissions();
  return scan;
}

float to_float(double value) {
  if (std::abs(value) > std::numeric_limits<float>::max())
    throw boxplus::InvalidArgument("expected a number that fits a float, got " + std::to_string(value));
  return static_cast<float>(value);
}

double number_of(float value, double of_file) {
  if (!std::isfinite(value)) return value;
  if (std::abs(of_file) <= std::numeric_limits<float>::max() && static_cast<float>(of_file) == value)
    return of_file;
  std::array<char, 32> text;
  double number = 0;
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  boxplus::number_from_chars(text.data(), end, number);
  return number;
}

}  // namespace adapters
}  // namespace g2o
