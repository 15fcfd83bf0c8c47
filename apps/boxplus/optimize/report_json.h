// SPDX-License-Identifier: BSD-3-Clause
// A Report as JSON, for scripts.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "boxplus/optimize/report.h"

namespace boxplus::app {

/// The robust kernel of --kernel; without a name there is none.
struct KernelFacts {
  std::string name;
  std::optional<double> width;   ///< from the command line
  std::map<int, double> widths;  ///< otherwise the defaults, by the rows of the edges
  std::size_t edges = 0;         ///< the number of edges with this kernel
};

/// Facts about the run that are not in the Report.
struct RunFacts {
  std::string input;
  std::size_t edges = 0;  ///< in the file
  std::int64_t skipped_lines = 0;
  KernelFacts kernel;
  double load_s = 0, total_s = 0;
};

/// One JSON object, indented, with a newline at its end. Values that are not finite become null.
std::string report_json(const Report& report, const RunFacts& facts);

}  // namespace boxplus::app
