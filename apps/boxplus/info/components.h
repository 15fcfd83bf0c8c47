// SPDX-License-Identifier: BSD-3-Clause
// The connected components of a graph, and the vertices and edges that hold each in place.
#pragma once

#include <vector>

#include "info/graph_facts.h"

namespace boxplus::app {

/// Fills components and isolated. O(n log n).
void find_components(const Graph& graph, const EdgeRoles& role_of_edge, GraphFacts& facts);

}  // namespace boxplus::app
