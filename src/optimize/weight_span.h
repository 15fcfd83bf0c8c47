// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "boxplus/linearize/plan.h"

namespace boxplus {

/// An edge between moving vertices, and one of these vertices. The weight of the edge is so large that H
/// loses the contribution of another edge at this vertex by rounding.
struct SwampingEdge {
  EdgeRef edge;
  VertexRef vertex;
};

/// Finds the swamping edge with the largest contribution to H at the current estimates. Because H loses the
/// contribution of the other edge, steps may ignore the measurement of the other edge. Takes O(edges).
/// Linearizes edges only if the largest diagonal entry of any Ω is so much larger than the smallest one that
/// double precision cannot hold their sum.
std::optional<SwampingEdge> find_swamping_edge(const Graph& graph, const Plan& plan);

}  // namespace boxplus
