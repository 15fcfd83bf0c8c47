// SPDX-License-Identifier: BSD-3-Clause
// Finds the connected components of a graph, and the vertices and edges that hold each component in place.
#pragma once

#include <vector>

#include "info/graph_facts.h"
#include "plan/plan.h"

namespace boxplus::app {

/// Sets `facts.components` and `facts.isolated`. `plan` is the plan of an optimization with default options.
/// Takes O(n log n) time.
void find_components(const Graph& graph, const Plan& plan, const EdgeRoles& role_of_edge, GraphFacts& facts);

}  // namespace boxplus::app
