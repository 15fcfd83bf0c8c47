// SPDX-License-Identifier: BSD-3-Clause
// Formats a Report as JSON, for scripts.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "boxplus/optimize/report.h"

namespace boxplus::app {

/// The robust kernel that --kernel names. If the name is empty, there is no kernel.
struct KernelFacts {
  std::string name;
  std::optional<double> width;  ///< the width from the command line, if any
  /// The default widths, if the command line has none. The key is the number of rows of an edge.
  std::map<int, double> widths;
  std::size_t edges = 0;  ///< the number of edges with this kernel
};

/// Facts about the run that are not in the Report.
struct RunFacts {
  std::string input;
  std::size_t edges = 0;  ///< the number of edges in the file
  std::int64_t skipped_lines = 0;
  KernelFacts kernel;
  double load_s = 0, total_s = 0;
};

/// Returns an indented JSON object that ends with a newline. Values that are not finite become null.
std::string report_json(const Report& report, const RunFacts& facts);

}  // namespace boxplus::app
