// SPDX-License-Identifier: BSD-3-Clause
#include "g2o/stuff/timeutil.h"

#include <iostream>

namespace g2o {

std::string getTimeAsString(std::time_t time) {
  std::tm parts{};
#if defined(_WIN32)
  localtime_s(&parts, &time);
#else
  localtime_r(&time, &parts);
#endif
  char text[32];
  return std::string(text, std::strftime(text, sizeof(text), "%Y%m%d_%H%M%S", &parts));
}

std::string getCurrentTimeAsString() {
  return getTimeAsString(std::time(nullptr));
}

ScopeTime::~ScopeTime() {
  std::cerr << _title << ' ' << 1000 * (get_monotonic_time() - _startTime) << " ms\n";
}

}  // namespace g2o
