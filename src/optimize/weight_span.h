// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "boxplus/linearize/plan.h"

namespace boxplus {

/// An edge between moving vertices whose weight leaves no digit of another edge's in H, and the vertex where
/// they meet.
struct SwampingEdge {
  EdgeRef edge;
  VertexRef vertex;
};

/// Finds the heaviest such edge at the current estimates: in a sum with it, double precision drops the other,
/// so a step can ignore what the other measures. O(edges); linearizes only if weights differ that much.
std::optional<SwampingEdge> find_swamping_edge(const Graph& graph, const Plan& plan);

}  // namespace boxplus
