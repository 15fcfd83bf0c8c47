// SPDX-License-Identifier: BSD-3-Clause
// Converts a Graph to a PlainGraph and back.
#pragma once

#include "boxplus/graph/graph.h"
#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// Converts a graph. The index of a pose or point is its slot. Throws std::runtime_error if the graph has an
/// edge type that the peers do not have.
PlainGraph numbers_of(const Graph& graph);

/// Sets the estimates of the graph from which `numbers` were taken.
void set_estimates(Graph& graph, const PlainGraph& numbers);

}  // namespace boxplus::bench
