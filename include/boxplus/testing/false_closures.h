// SPDX-License-Identifier: BSD-3-Clause
// Adds false loop closures to a pose graph, to test methods that find them.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

struct FalseClosureOptions {
  double fraction = 0.5;  ///< of all closures, after the false ones were added; in [0, 1)
  /// The false closures come in groups of at most this many, with sizes that are uniformly distributed. The
  /// closures of a group connect two stretches of consecutive poses, and agree with each other.
  int group = 1;
  std::uint64_t seed = 1;
};

/// Adds closures between random poses to a graph of Between<SE2> or Between<SE3>. The order of the ids is the
/// order of the poses. Each group copies the measurement and the information of a random true closure, as if
/// it mistook one place for another. Call this function at good estimates (those of an optimized graph): they
/// determine the motions along a group, and a pair of poses is used only if the chi2 of its closure is above
/// 100 per row. Adds fewer closures if such pairs are not found.
///
/// Returns the new edges. Throws InvalidArgument if the options are out of their ranges, and if the graph has
/// no loop closure of these types.
std::vector<EdgeRef> add_false_closures(Graph& graph, const FalseClosureOptions& options = {});

}  // namespace boxplus
