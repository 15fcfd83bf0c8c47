// SPDX-License-Identifier: BSD-3-Clause
// Forgets vertices, but keeps what they say about others.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// Removes vertices with all of their edges. Adds a dense prior on the vertices that share edges with them,
/// so that the quadratic model of the problem at the current estimates keeps its minimum and its covariance
/// (the Schur complement). Returns the prior, or nothing if no other vertex that can move shares an edge with
/// them.
///
/// The prior is an edge of the graph like all others, on vertices of any types. It keeps the estimates of its
/// vertices as its linearization points. So marginalize vertices only when the graph is at its optimum.
///
/// Only enabled edges of level 0 count, with their robust weights at the current estimates. Directions of the
/// vertices that their edges do not determine say nothing about the others. O(d³) for d scalars of the
/// vertices and their neighbors. Throws InvalidArgument, and changes nothing, if a vertex is
/// stale, fixed or a parameter, appears twice, or has bounds or a constraint, and if an error or a Jacobian
/// is not finite.
std::optional<EdgeRef> marginalize(Graph& graph, std::span<const VertexRef> vertices);
inline std::optional<EdgeRef> marginalize(Graph& graph, std::initializer_list<VertexRef> vertices) {
  return marginalize(graph, std::span(vertices.begin(), vertices.size()));
}

}  // namespace boxplus
