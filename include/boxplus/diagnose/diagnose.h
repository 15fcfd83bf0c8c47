// SPDX-License-Identifier: BSD-3-Clause
// Says what is wrong with a graph: why an optimization fails, or why its result is doubtful.
#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/diagnose/finding.h"
#include "boxplus/graph/graph.h"
#include "boxplus/options/options.h"

namespace boxplus {

using detail::Finding;
using detail::to_string;

struct [[nodiscard]] Diagnosis {
  std::vector<Finding> findings;  ///< errors first, then warnings, then notes
  /// False if Options::stop or Options::time_limit_s ended the diagnosis. `findings` is then not complete.
  bool is_complete = true;
  /// Whether chi2 is at a minimum as far as single vertices show: no vertex can lower it noticeably while all
  /// others stay where they are. If it is false, the diagnosis does not look for outliers or judge chi2.
  bool at_minimum = false;

  /// Whether there are only notes.
  bool ok() const;
  /// The number of findings of this severity.
  std::size_t count(Finding::Severity severity) const;
};
/// One line per finding, such as "warning: vertex 20 has no edge: … [isolated-vertex]".
std::string to_string(const Diagnosis& diagnosis);
std::ostream& operator<<(std::ostream& out, const Diagnosis& diagnosis);

/// Examines a graph at its current estimates: before a run, after a run that failed, or after a run whose
/// result is doubtful. Changes nothing. The options `level`, `vertices`, `edges`, `numeric_jacobians`, `stop`
/// and `time_limit_s` mean the same as for optimize(); all other options are ignored. Disabled edges are
/// ignored, too.
///
/// Evaluates each edge and its Jacobians once, in one thread. Examines samples of the edges to find wrong
/// Jacobians, and looks for the gauge freedom of each component as optimize() does. O(n log n).
///
/// Throws InvalidArgument for stale handles in the options, and passes on the exceptions of error functions.
Diagnosis diagnose(const Graph& graph, const Options& options = {});

}  // namespace boxplus
