// SPDX-License-Identifier: BSD-3-Clause
// From a Graph to bare numbers and back.
#pragma once

#include "boxplus/graph/graph.h"
#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// Poses and points are numbered as their slots. Throws std::runtime_error for an edge type that the peers
/// do not have.
PlainGraph numbers_of(const Graph& graph);

/// Overwrites the estimates of the graph that `numbers` were taken from.
void set_estimates(Graph& graph, const PlainGraph& numbers);

}  // namespace boxplus::bench
