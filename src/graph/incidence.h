// SPDX-License-Identifier: BSD-3-Clause
// An index of the edges that use a vertex.
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// A list of edges per vertex. Removed edges stay in a list until it is read or grows. They are recognized,
/// because their handles are stale.
class Graph::Incidence {
 public:
  /// O(vertices + edges).
  explicit Incidence(const Graph& graph);

  /// Amortized O(1) per vertex. If it throws, the caller must drop the index.
  void add(const Graph& graph, EdgeRef edge, std::span<const VertexRef> vertices);
  /// The edges of a vertex, sorted. O(d log d).
  const std::vector<EdgeRef>& edges(const Graph& graph, VertexRef vertex);
  /// The same for a vertex that is to be removed.
  std::vector<EdgeRef> take(const Graph& graph, VertexRef vertex);

 private:
  std::vector<EdgeRef>& list(VertexRef vertex);

  std::vector<std::vector<std::vector<EdgeRef>>> edges_;  // by pool and slot of the vertex
};

}  // namespace boxplus
