// SPDX-License-Identifier: BSD-3-Clause
// Construction, copies and moves of a Graph.
#include <atomic>
#include <utility>

#include "boxplus/graph/graph.h"
#include "graph/incidence.h"

namespace boxplus {

Graph::Graph() = default;
Graph::~Graph() = default;

std::uint32_t Graph::new_epoch() noexcept {
  static std::atomic<std::uint32_t> epochs = 0;
  constexpr std::uint32_t kGoldenRatio = 0x9E3779B9;  // 2^32 / golden ratio; spreads its multiples evenly
  return kGoldenRatio * epochs.fetch_add(1, std::memory_order_relaxed);
}

Graph::Saved::Saved(const Saved& other) {
  for (const Part& part : other.parts)
    parts.push_back({part.slots, part.generations, part.estimates ? part.estimates->clone() : nullptr});
}

// Does not copy the index of edges, because edges() builds a new one when it is needed. The elements keep
// their generations, so the handles of `other` are also valid for the copy. The generations of new elements
// start at a different number in the copy, so handles to new elements are valid for one graph only.
Graph::Graph(const Graph& other)
    : edge_access_(other.edge_access_),
      vertex_pool_of_(other.vertex_pool_of_),
      edge_pool_of_(other.edge_pool_of_),
      last_vertex_pool_(other.last_vertex_pool_),
      last_edge_pool_(other.last_edge_pool_),
      vertex_ids_(other.vertex_ids_),
      parameter_ids_(other.parameter_ids_),
      next_id_(other.next_id_),
      next_parameter_id_(other.next_parameter_id_),
      revision_(other.revision_),
      last_rewrite_(other.last_rewrite_),
      stack_(other.stack_) {
  for (const auto& pool : other.vertex_pools_) {
    vertex_pools_.push_back(pool->clone());
    vertex_pools_.back()->next_generation_ = epoch_;
  }
  for (const auto& pool : other.edge_pools_) {
    edge_pools_.push_back(pool->clone(vertex_pools_));
    edge_pools_.back()->next_generation_ = epoch_;
  }
}

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
  vertex_pools_ = std::move(other.vertex_pools_);
  edge_pools_ = std::move(other.edge_pools_);
  edge_access_ = std::move(other.edge_access_);
  last_vertex_pool_ = std::exchange(other.last_vertex_pool_, {});
  last_edge_pool_ = std::exchange(other.last_edge_pool_, {});
  vertex_pool_of_ = std::move(other.vertex_pool_of_);
  edge_pool_of_ = std::move(other.edge_pool_of_);
  vertex_ids_ = std::exchange(other.vertex_ids_, {});
  parameter_ids_ = std::exchange(other.parameter_ids_, {});
  next_id_ = other.next_id_;
  next_parameter_id_ = other.next_parameter_id_;
  revision_ = other.revision_;
  last_rewrite_ = other.last_rewrite_;
  epoch_ = std::exchange(other.epoch_, new_epoch());
  stack_ = std::move(other.stack_);
  incidence_ = std::move(other.incidence_);
}

}  // namespace boxplus
