// SPDX-License-Identifier: BSD-3-Clause
// Counts the active edges of a plan by their present state, and what they can determine.
#pragma once

#include <cstdint>
#include <vector>

#include "system/run_system.h"

namespace boxplus {

struct EdgeCounts {
  std::uint64_t rows = 0;  ///< of the errors of the enabled edges, with weighted_rows() of each
  std::uint32_t disabled = 0;
  std::uint32_t robust = 0;  ///< enabled edges that have a robust kernel
};

/// Keeps its memory from one count to the next.
class EdgeCounter {
 public:
  /// O(edges).
  EdgeCounts count(const Graph& graph, const Plan& plan);
  /// The unknowns of vertices with more unknowns than their edges have rows, beyond these rows: one of a
  /// point that one camera sees. Directions that the plan holds because of gauge freedom do not count, nor do
  /// those of the plan's undetermined_blocks. After count() for this system. If several processes share the
  /// problem, counts the unknowns of this one.
  std::uint64_t undetermined(const Graph& graph, RunSystem& system);

 private:
  std::vector<std::vector<std::uint64_t>> rows_;  // of the edges of each vertex, by pool and slot
  std::vector<double> rows_of_, unknowns_of_;     // of each vertex, at its first scalar
};

}  // namespace boxplus
