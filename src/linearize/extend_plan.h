// SPDX-License-Identifier: BSD-3-Clause
// Extends a plan after elements were appended to its graph.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "boxplus/linear/linear_solver.h"
#include "boxplus/linearize/plan.h"

namespace boxplus {

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

/// Extends `plan`, which make_plan() made for `request`, by the elements that were appended to the graph
/// since then. In vertex pool p, these are the slots from vertices[p] on. In edge pool p, these are the slots
/// from edges[p] on. The result is the same as a new plan.
///
/// Requires is_extensible(). Returns nullopt and changes nothing if the additions need a new plan. They need
/// no new plan if the new vertices have higher ids than the old vertices and are connected to them, if the
/// gauge does not change, and if the additions have no new pool, no eliminated vertices and no run-time
/// sizes. Takes O(blocks of H + edges) cheap steps.
std::optional<PlanGrowth> extend_plan(const Graph& graph, const PlanRequest& request,
                                      std::span<const std::uint32_t> vertices,
                                      std::span<const std::uint32_t> edges, Plan& plan);

}  // namespace boxplus
