// SPDX-License-Identifier: BSD-3-Clause
// An index of the edges that use a vertex.
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// A list of edges for each vertex. A removed edge stays in the list until the list is read or grows; the
/// stale handle shows that the edge was removed.
class Graph::Incidence {
 public:
  /// O(vertices + edges).
  explicit Incidence(const Graph& graph);

  /// Adds an edge. Amortized O(1) per vertex. If this throws, the caller must discard the whole index.
  void add(const Graph& graph, EdgeRef edge, std::span<const VertexRef> vertices);
  /// The edges of a vertex, sorted. O(d log d) for d edges.
  const std::vector<EdgeRef>& edges(const Graph& graph, VertexRef vertex);
  /// Like edges(), but also clears the list, because the caller is about to remove the vertex.
  std::vector<EdgeRef> take(const Graph& graph, VertexRef vertex);

 private:
  std::vector<EdgeRef>& list(VertexRef vertex);

  std::vector<std::vector<std::vector<EdgeRef>>> edges_;  // by pool and slot of the vertex
};

}  // namespace boxplus
