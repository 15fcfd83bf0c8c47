// SPDX-License-Identifier: BSD-3-Clause
// Which edges use a vertex.
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// A list of edges per vertex. Removed edges stay listed until their list is read, or grows: their handles
/// are stale, so they are recognized.
class Graph::Incidence {
 public:
  /// O(vertices + edges).
  explicit Incidence(const Graph& graph);

  /// Amortized O(1) per vertex. Where it throws, the index must be dropped.
  void add(const Graph& graph, EdgeRef edge, std::span<const VertexRef> vertices);
  /// The edges of a vertex, sorted. O(d log d).
  const std::vector<EdgeRef>& edges(const Graph& graph, VertexRef vertex);
  /// The same, of a vertex that goes away.
  std::vector<EdgeRef> take(const Graph& graph, VertexRef vertex);

 private:
  std::vector<EdgeRef>& list(VertexRef vertex);

  std::vector<std::vector<std::vector<EdgeRef>>> edges_;  // by pool and slot of the vertex
};

}  // namespace boxplus
