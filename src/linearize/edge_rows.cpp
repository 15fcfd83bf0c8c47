// SPDX-License-Identifier: BSD-3-Clause
#include "linearize/edge_rows.h"

namespace boxplus {

EdgeRows::EdgeRows(const Graph& graph, const Plan& plan) : graph_(graph) {
  for (const auto& pool : graph.vertex_pools())
    block_of_.emplace_back(pool->slots(), BlockStructure::kAbsent);
  for (std::uint32_t block = 0; block < plan.structure.blocks(); ++block) {
    const VertexRef& vertex = plan.block_vertex[block];
    block_of_[vertex.pool][vertex.slot] = block;
  }
}

void EdgeRows::linearize(const detail::EdgePool& pool, std::uint32_t edge, bool force_numeric) {
  const detail::EdgeShape shape = pool.shape(edge);
  error_.resize(static_cast<std::size_t>(shape.rows));
  jacobian_.resize(static_cast<std::size_t>(shape.rows) * static_cast<std::size_t>(shape.cols));
  tile_.error = error_.data();
  tile_.jacobian = jacobian_.data();
  tile_.in_lanes = false;
  pool.linearize(std::span(&edge, 1), tile_, force_numeric);
  columns_.clear();
  const auto slots = pool.vertex_slots(edge);
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const std::uint32_t p = pool.vertex_pool(edge, static_cast<int>(i));
    const auto dim = static_cast<std::uint32_t>(graph_.vertex_pools()[p]->tangent_dim(slots[i]));
    for (std::uint32_t direction = 0; direction < dim; ++direction)
      columns_.push_back({block_of_[p][slots[i]], direction});
  }
}

}  // namespace boxplus
