// SPDX-License-Identifier: BSD-3-Clause
// Construction, copies and moves of a Graph.
#include <utility>

#include "boxplus/graph/graph.h"
#include "graph/incidence.h"

namespace boxplus {

Graph::Graph() = default;
Graph::~Graph() = default;

// Does not copy the index of edges, because edges() builds a new one when it is needed.
Graph::Graph(const Graph& other)
    : pools_(other.pools_),
      vertex_ids_(other.vertex_ids_),
      parameter_ids_(other.parameter_ids_),
      next_id_(other.next_id_),
      next_parameter_id_(other.next_parameter_id_),
      revision_(other.revision_),
      stack_(other.stack_) {}

Graph& Graph::operator=(const Graph& other) {
  return *this = Graph(other);
}

Graph::Graph(Graph&& other) noexcept : Graph() {
  *this = std::move(other);
}

Graph& Graph::operator=(Graph&& other) noexcept {
  if (this == &other) return *this;
  lifetime_ = std::move(other.lifetime_);
  take_elements(other);
  return *this;
}

void Graph::take_elements(Graph& other) noexcept {
  pools_ = std::move(other.pools_);
  vertex_ids_ = std::exchange(other.vertex_ids_, {});
  parameter_ids_ = std::exchange(other.parameter_ids_, {});
  next_id_ = other.next_id_;
  next_parameter_id_ = other.next_parameter_id_;
  revision_ = other.revision_;
  stack_ = std::move(other.stack_);
  incidence_ = std::move(other.incidence_);
  log_ = other.log_ = nullptr;  // the observers of both graphs see that their lives are over
}

}  // namespace boxplus
