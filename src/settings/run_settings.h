// SPDX-License-Identifier: BSD-3-Clause
// What a user chooses for a run.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"
#include "boxplus/outliers/outliers.h"

namespace boxplus {

/// Settings by name, with their values as texts, as a page sends them. Absent ones have their defaults.
using Settings = std::map<std::string, std::string, std::less<>>;

enum class KernelScope : std::uint8_t { kAll, kLoopClosures };

struct RunSettings {
  RunSettings() { options.start = Start::kAutomatic; }

  Options options;
  std::optional<Suspects> suspects;    ///< the edges that may be false, if the run is that of find_outliers()
  std::string kernel;                  ///< the name of the robust kernel; empty if edges get no kernel
  std::optional<double> kernel_width;  ///< if absent, the default for the rows of each edge
  KernelScope kernel_scope = KernelScope::kAll;
};

/// What robustify() did. If the name is empty, there is no kernel.
struct KernelFacts {
  std::string name;
  std::optional<double> width;  ///< the width that the user chose, if any
  /// The default widths, if the user chose none. The key is the number of rows of an edge.
  std::map<int, double> widths;
  std::size_t edges = 0;  ///< the number of edges with this kernel
};

/// Sets the chosen kernel on the chosen edges, and removes the kernels of all other edges.
KernelFacts robustify(Graph& graph, const RunSettings& settings);

}  // namespace boxplus
