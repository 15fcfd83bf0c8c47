// SPDX-License-Identifier: BSD-3-Clause
// Converts a Graph to a PlainGraph and back.
#pragma once

#include "boxplus/graph/graph.h"
#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// Converts a graph. The index of a pose or point is its slot in the graph's vertex pool. Throws
/// std::runtime_error if the graph has an edge type that PlainGraph does not have.
PlainGraph numbers_of(const Graph& graph);

/// Copies the poses and points in `numbers` to the estimates of `graph`. `numbers` must have the sizes of
/// numbers_of(graph).
void set_estimates(Graph& graph, const PlainGraph& numbers);

}  // namespace boxplus::bench
