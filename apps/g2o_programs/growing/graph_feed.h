// SPDX-License-Identifier: BSD-3-Clause
// Feeds a graph that was read from a file into another graph, in the order in which a robot measures it.
#pragma once

#include <cstddef>
#include <vector>

#include "boxplus/graph/graph.h"
#include "guess/placement.h"

namespace boxplus::programs {

/// An edge belongs to the step of its pose with the largest id (if it has no pose, of its vertex with the
/// largest id). In a step, edges between poses come first, and otherwise the order of the file holds. A
/// vertex comes with the first edge that uses it.
class GraphFeed {
 public:
  /// Both graphs must outlive this object, and `target` must be empty. Adds the parameters to it.
  GraphFeed(const Graph& source, const std::vector<EdgeRef>& edges, Graph& target);

  /// Adds the edges of the next step and their vertices. Returns false if no edge is left; all vertices
  /// without edges are then added. Throws InvalidArgument if the type of an element has no tag.
  bool step();

  /// Copies the estimates of the target to a graph with the same vertices (by their ids).
  void copy_estimates_to(Graph& graph) const;

 private:
  struct Item {
    Id step;
    bool has_other;  // than poses
    EdgeRef edge;
  };

  Item item_of(EdgeRef edge);
  VertexRef counterpart(VertexRef vertex);
  VertexRef copy(VertexRef vertex, bool is_parameter);
  void copy(EdgeRef edge);

  const Graph& source_;
  Graph& target_;
  Placement placement_;
  std::vector<Item> items_;
  std::size_t next_ = 0;
};

}  // namespace boxplus::programs
