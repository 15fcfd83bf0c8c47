// SPDX-License-Identifier: BSD-3-Clause
// The parts of a graph that hang together, and what holds each in place.
#pragma once

#include <vector>

#include "info/graph_facts.h"

namespace boxplus::app {

/// Fills components and isolated. O(n log n).
void find_components(const Graph& graph, const EdgeRoles& role_of_edge, GraphFacts& facts);

}  // namespace boxplus::app
