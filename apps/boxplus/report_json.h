// SPDX-License-Identifier: BSD-3-Clause
// A Report as JSON, for scripts.
#pragma once

#include <string>

#include "boxplus/optimize/report.h"

namespace boxplus::app {

/// What only the command knows.
struct RunFacts {
  std::string input;
  double load_s = 0, total_s = 0;
};

/// One JSON object, indented, with a newline at its end. Numbers that are not finite become null.
std::string report_json(const Report& report, const RunFacts& facts);

}  // namespace boxplus::app
