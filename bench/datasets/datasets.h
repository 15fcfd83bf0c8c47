// SPDX-License-Identifier: BSD-3-Clause
// The public graphs of the benchmark, and the optimum of each.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "boxplus/io/graph_file.h"

namespace boxplus::bench {

struct Dataset {
  std::string_view path;  ///< the path of the file in the folder of data sets
  double best_chi2;       ///< the lowest chi2 that several independent optimizers reached
  bool counts;            ///< true if the geometric means of the goals include this file

  /// Returns the name of the file without its folder and extension.
  std::string name() const;
  /// Returns the target: a run has arrived if its chi2 is at most this.
  double target() const { return best_chi2 * (1 + 1e-6); }
};

std::span<const Dataset> datasets();

/// Reads a file with one thread. Fixes the vertices that optimize() would hold, so that the peers hold the
/// same vertices.
GraphFile read_anchored(const std::string& path);

}  // namespace boxplus::bench
