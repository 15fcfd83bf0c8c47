// SPDX-License-Identifier: BSD-3-Clause
// Converts a Graph to a PlainGraph and back.
#pragma once

#include "boxplus/graph/graph.h"
#include "datasets/plain_graph.h"

namespace boxplus::bench {

/// Poses and points have the indices of their slots. Throws std::runtime_error for an edge type that the
/// peers do not have.
PlainGraph numbers_of(const Graph& graph);

/// Overwrites the estimates of the graph from which `numbers` were taken.
void set_estimates(Graph& graph, const PlainGraph& numbers);

}  // namespace boxplus::bench
