// SPDX-License-Identifier: BSD-3-Clause
// Gives the vertices of a graph to a Smoother one by one, as a robot would.
#pragma once

#include <cstddef>
#include <vector>

#include "boxplus/graph/graph.h"
#include "guess/placement.h"

namespace boxplus::app {

/// Lets the vertices of a graph take part one by one, as a robot would add them. Step k adds the vertex with
/// the k-th lowest id, and the edges between it and vertices before it. An edge has level 1, and takes no
/// part, until its last vertex is added. The first edge of a new pose or point gives its estimate; those of
/// the file count only for fixed vertices.
class FileFeed {
 public:
  /// `graph` must outlive this object.
  explicit FileFeed(Graph& graph);

  std::size_t steps() const { return vertices_.size(); }
  /// Adds step `step`, from 0. Call it for all steps in their order.
  void add(std::size_t step);

 private:
  Graph& graph_;
  std::vector<VertexRef> vertices_;
  std::vector<std::vector<EdgeRef>> edges_;  // of each step
  Placement placement_;
};

}  // namespace boxplus::app
