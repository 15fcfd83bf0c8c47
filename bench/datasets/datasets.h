// SPDX-License-Identifier: BSD-3-Clause
// The public graphs of the benchmark, and the optimum of each.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "boxplus/io/graph_file.h"

namespace boxplus::bench {

struct Dataset {
  std::string_view path;  ///< below the folder of data sets
  double best_chi2;       ///< the lowest that several independent optimizers reached
  bool counts;            ///< in the geometric means of the goals

  /// The file's name without its folder and ending.
  std::string name() const;
  /// A run has arrived if its chi2 is at most this.
  double target() const { return best_chi2 * (1 + 1e-6); }
};

std::span<const Dataset> datasets();

/// Reads a file with one thread, and fixes the vertices that optimize() would hold, so that peers hold the
/// same.
GraphFile read_anchored(const std::string& path);

}  // namespace boxplus::bench
