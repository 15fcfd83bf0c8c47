// SPDX-License-Identifier: BSD-3-Clause
// The public graphs that are measured, and the optimum of each.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "boxplus/io/graph_file.h"

namespace boxplus::bench {

struct Dataset {
  std::string_view path;  ///< below the folder of data sets
  double best_chi2;       ///< the lowest that several independent optimisers reached
  bool counts;            ///< towards the geometric means that the goals are about

  /// The file's name without folder and ending.
  std::string name() const;
  /// A run has arrived when its chi2 is at most this.
  double target() const { return best_chi2 * (1 + 1e-6); }
};

std::span<const Dataset> datasets();

/// Reads a file with one thread and fixes what optimize() would hold, so that peers can hold the same.
GraphFile read_anchored(const std::string& path);

}  // namespace boxplus::bench
