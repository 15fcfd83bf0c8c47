// SPDX-License-Identifier: BSD-3-Clause
// The words of findings: names of vertices, edges and directions.
#pragma once

#include <span>
#include <string>

#include "boxplus/diagnose/finding.h"
#include "boxplus/graph/graph.h"
#include "gauge/free_motions.h"

namespace boxplus {

using detail::Finding;
using detail::to_string;

/// "pose 20", "points 3, 7, 9", "vertices 12…40", "poses 3, 5, 8, 9, 12, … (24 in all)". The vertices are
/// sorted by id.
std::string vertices_text(const Graph& graph, std::span<const VertexRef> vertices);
/// "the edge Between<SE2> of vertices 3, 4", "12 edges, such as Between<SE2> of vertices 3, 4".
std::string edges_text(const Graph& graph, std::span<const EdgeRef> edges);
/// "in x, y and yaw", "in scale and along (0.6, 0.8, 0)".
std::string motions_text(const FreeMotions& motions);
/// The name of a direction in the tangent space of a vertex: "x", "yaw", "roll", "direction 7" (counted from
/// 0), or "(0.6, 0.8, 0)" if it is no axis.
std::string direction_text(const Graph& graph, VertexRef vertex, std::span<const double> tangent);
/// `singular` or `plural`, depending on the count.
inline const char* by_count(std::size_t count, const char* singular, const char* plural) {
  return count == 1 ? singular : plural;
}

/// kNote if at most one in a hundred is concerned, because so few elements do not spoil the rest; otherwise
/// kWarning.
inline Finding::Severity severity_by_share(std::size_t count, std::size_t total) {
  return 100 * count <= total ? Finding::Severity::kNote : Finding::Severity::kWarning;
}

/// Sorts by id.
void sort_by_id(const Graph& graph, std::vector<VertexRef>& vertices);
/// The directions of a component, for Finding::directions.
void append_directions(const FreeMotions& motions, std::vector<Finding::Direction>& out);

}  // namespace boxplus
