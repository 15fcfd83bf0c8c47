// SPDX-License-Identifier: BSD-3-Clause
#include "graph/incidence.h"

#include <algorithm>
#include <utility>

namespace boxplus {

Graph::Incidence::Incidence(const Graph& graph) {
  for (const auto& pool : graph.vertex_pools()) edges_.emplace_back(pool->slots());
  for (const EdgeRef& edge : graph.all_edges()) {
    const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
    int position = 0;
    for (const std::uint32_t slot : pool.vertex_slots(edge.slot))
      edges_[pool.vertex_pool(edge.slot, position++)][slot].push_back(edge);
  }
}

std::vector<EdgeRef>& Graph::Incidence::list(VertexRef vertex) {
  if (edges_.size() <= vertex.pool) edges_.resize(vertex.pool + 1);
  auto& lists = edges_[vertex.pool];
  if (lists.size() <= vertex.slot) lists.resize(vertex.slot + 1);
  return lists[vertex.slot];
}

void Graph::Incidence::add(const Graph& graph, EdgeRef edge, std::span<const VertexRef> vertices) {
  for (const VertexRef& vertex : vertices) {
    std::vector<EdgeRef>& edges = list(vertex);
    if (edges.size() == edges.capacity()) {
      std::erase_if(edges, [&](const EdgeRef& old) { return !graph.contains(old); });
      edges.reserve(2 * edges.size() + 1);
    }
    edges.push_back(edge);
  }
}

const std::vector<EdgeRef>& Graph::Incidence::edges(const Graph& graph, VertexRef vertex) {
  std::vector<EdgeRef>& edges = list(vertex);
  std::erase_if(edges, [&](const EdgeRef& edge) { return !graph.contains(edge); });
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<EdgeRef> Graph::Incidence::take(const Graph& graph, VertexRef vertex) {
  edges(graph, vertex);
  return std::exchange(list(vertex), {});
}

std::vector<EdgeRef> Graph::edges(VertexRef vertex) const {
  check(vertex);
  if (!incidence_) incidence_ = std::make_unique<Incidence>(*this);
  return incidence_->edges(*this, vertex);
}

void Graph::index_edge(EdgeRef edge, std::span<const VertexRef> vertices) noexcept {
  try {
    incidence_->add(*this, edge, vertices);
  } catch (...) {
    incidence_.reset();  // the next call of edges() builds a new index
  }
}

/// Finds the edges of a vertex without an index. Takes O(edges of the graph).
std::vector<EdgeRef> Graph::find_edges(VertexRef vertex) const {
  std::vector<EdgeRef> result;
  for (std::uint32_t p = 0; p < pools_.edges.size(); ++p) {
    const detail::EdgePool& pool = *pools_.edges[p];
    for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
      if (!pool.alive(edge)) continue;
      const auto slots = pool.vertex_slots(edge);
      for (std::size_t i = 0; i < slots.size(); ++i) {
        if (slots[i] != vertex.slot || pool.vertex_pool(edge, static_cast<int>(i)) != vertex.pool) continue;
        result.push_back({p, edge, pool.generation(edge)});
        break;
      }
    }
  }
  return result;
}

void Graph::remove(VertexRef vertex) {
  check(vertex);
  const std::vector<EdgeRef> edges = incidence_ ? incidence_->take(*this, vertex) : find_edges(vertex);
  for (const EdgeRef& edge : edges) {
    pools_.edges[edge.pool]->remove(edge.slot);
    note_change(edge);
  }
  detail::VertexPool& pool = *pools_.vertices[vertex.pool];
  (pool.parameter(vertex.slot) ? parameter_ids_ : vertex_ids_).erase(pool.id(vertex.slot));
  pool.release_slot(vertex.slot);
  note_new_structure();
  note_change(vertex);
}

}  // namespace boxplus
