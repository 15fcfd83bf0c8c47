// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "boxplus/linearize/plan.h"

namespace boxplus {

/// An edge between moving vertices with such a large weight that another edge rounds to nothing in H, and the
/// vertex that both edges touch.
struct SwampingEdge {
  EdgeRef edge;
  VertexRef vertex;
};

/// Finds the heaviest such edge at the current estimates. In a sum with its contribution, double precision
/// loses that of the other edge, so a step can ignore the other measurement. O(edges); linearizes only if
/// weights differ that much.
std::optional<SwampingEdge> find_swamping_edge(const Graph& graph, const Plan& plan);

}  // namespace boxplus
