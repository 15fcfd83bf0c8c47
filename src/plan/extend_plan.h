// SPDX-License-Identifier: BSD-3-Clause
// Extends a plan after elements were added to its graph.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "plan/plan.h"

namespace boxplus {

/// Tells the elements that a graph had when a plan was made from those that were added since: the next
/// generation of each pool at that time.
struct PlannedElements {
  std::vector<std::uint32_t> vertices, edges;

  void note(const Graph& graph);
  bool has_vertex(const Graph& graph, std::uint32_t pool, std::uint32_t slot) const;
};

/// Owns the data of a StructureGrowth, which describes how H grows.
struct PlanGrowth {
  std::uint32_t old_blocks = 0;
  std::vector<BlockCoordinate> added;
  std::vector<std::uint32_t> new_index;

  StructureGrowth of_structure() const { return {old_blocks, added, new_index}; }
};

/// Whether extend_plan() supports the plan. The problem must be connected, and have at most one held vertex,
/// no other gauge freedom, no fixed directions, no eliminated vertices and no parameters. An extended plan
/// also satisfies these conditions. Takes O(nonzero blocks of H).
bool is_extensible(const Graph& graph, const Plan& plan);

/// Extends `plan`, which make_plan() made for `request`, by the elements that were added to the graph since
/// then. `planned` tells which these are. The result is the same as a new plan, except that the new elements
/// of a list come after the old ones, even if they use slots that removed elements had left.
///
/// Requires is_extensible(). Returns nullopt and changes nothing if the additions need a new plan. They need
/// no new plan if the new vertices have higher ids than the old vertices and are connected to them, if the
/// gauge does not change, and if the additions have no new pool, no eliminated vertices and no run-time
/// sizes. Takes O(blocks of H + edges) cheap steps.
std::optional<PlanGrowth> extend_plan(const Graph& graph, const PlanRequest& request,
                                      const PlannedElements& planned, Plan& plan);

}  // namespace boxplus
