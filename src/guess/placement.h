// SPDX-License-Identifier: BSD-3-Clause
// Initial estimates of vertices that are added to a graph one by one.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// Places each new pose or point by the first edge that measures its frame relative to a vertex that has its
/// place. O(1) per edge.
class Placement {
 public:
  /// `graph` must outlive this object.
  explicit Placement(Graph& graph) : graph_(graph) {}

  /// The estimate of this vertex is a default: an edge may replace it.
  void expect(VertexRef vertex) { waiting_.insert(key(vertex)); }
  /// The estimate of this vertex must stay as it is.
  void keep(VertexRef vertex) { waiting_.erase(key(vertex)); }
  /// Places the vertices of a new edge that wait for a place, as far as this edge determines them. If all of
  /// its vertices wait, the vertex with the lower id keeps its estimate: it begins a new part of the graph.
  void place_by(EdgeRef edge);

 private:
  static std::uint64_t key(VertexRef vertex) {
    return std::uint64_t{vertex.pool} << 32 | std::uint64_t{vertex.slot};
  }
  bool waits(VertexRef vertex) const { return waiting_.count(key(vertex)) > 0; }
  void set_frame(VertexRef vertex, const detail::Frame& frame);

  Graph& graph_;
  std::unordered_set<std::uint64_t> waiting_;
};

}  // namespace boxplus
