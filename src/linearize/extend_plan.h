// SPDX-License-Identifier: BSD-3-Clause
// A plan that grows with its graph.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "boxplus/linearize/plan.h"

namespace boxplus {

/// How H has grown: see StructureGrowth.
struct PlanGrowth {
  std::uint32_t old_blocks = 0;
  std::vector<BlockCoordinate> added;
  std::vector<std::uint32_t> new_index;

  StructureGrowth of_structure() const { return {old_blocks, added, new_index}; }
};

/// Whether H is the matrix of one connected problem that one gauge holds, or none: a condition of
/// extend_plan(), which keeps it. O(blocks of H).
bool is_extensible(const Graph& graph, const Plan& plan);

/// Appends to `plan`, which make_plan() made for `request`, what was appended to the graph since: the slots
/// from `vertices[p]` (`edges[p]`) on of pool p. A new plan would be the same.
///
/// Empty, and nothing has changed, unless the new elements only prolong what there is: new vertices have
/// higher ids and hang on the old ones, the gauge stays as it is, and no pool, elimination or run-time size
/// comes in. O(blocks of H + edges) light steps.
std::optional<PlanGrowth> extend_plan(const Graph& graph, const PlanRequest& request,
                                      std::span<const std::uint32_t> vertices,
                                      std::span<const std::uint32_t> edges, Plan& plan);

}  // namespace boxplus
