// SPDX-License-Identifier: BSD-3-Clause
// Edges whose vertex types are known only at run time.
#include <string>
#include <utility>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

std::uint32_t Graph::add_edge_pool(std::unique_ptr<detail::EdgePool> pool) {
  for (const std::uint32_t vertices : pool->vertex_pools_) {
    if (vertices >= pools_.vertices.size()) {
      throw InvalidArgument("edge pool: expected the index of a vertex pool below " +
                            std::to_string(pools_.vertices.size()) + ", got " + std::to_string(vertices));
    }
  }
  return pools_.add_edges(std::move(pool));
}

EdgeRef Graph::add_edge(std::uint32_t pool, std::span<const VertexRef> vertices,
                        detail::FunctionRef<std::uint32_t(std::span<const std::uint32_t>)> add) {
  if (pool >= pools_.edges.size())
    throw InvalidArgument("add_edge: there is no edge pool " + std::to_string(pool));
  detail::EdgePool& edges = *pools_.edges[pool];
  const bool has_tails = edges.tails_ > 0;  // then, the pool itself knows which vertices it takes
  if (!has_tails && vertices.size() != edges.vertex_pools_.size()) {
    throw InvalidArgument("add_edge: expected " + std::to_string(edges.vertex_pools_.size()) +
                          " vertices, got " + std::to_string(vertices.size()));
  }
  std::vector<std::uint32_t> slots;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    check(vertices[i]);
    if (!has_tails && vertices[i].pool != edges.vertex_pools_[i])
      throw_wrong_type(vertices[i], pools_.vertices[edges.vertex_pools_[i]]->type_name());
    slots.push_back(vertices[i].slot);
  }
  check_distinct(vertices);
  const std::uint32_t slot = add(slots);
  note_new_structure();
  const EdgeRef edge{pool, slot, edges.generation(slot)};
  note_change(edge);
  if (incidence_) index_edge(edge, vertices);
  return edge;
}

}  // namespace boxplus
