// SPDX-License-Identifier: BSD-3-Clause
// The public graphs of the benchmark, with the best known chi2 of each.
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
  /// Returns the target of the optimizers, which is slightly above best_chi2.
  double target() const { return best_chi2 * (1 + 1e-6); }
};

std::span<const Dataset> datasets();

/// Reads a file with one thread. If the gauge is free, optimize() keeps some vertices constant. This function
/// fixes these vertices, so that Ceres keeps the same ones constant.
GraphFile read_anchored(const std::string& path);

}  // namespace boxplus::bench
