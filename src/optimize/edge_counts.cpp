// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/edge_counts.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "graph/weighted_rows.h"

namespace boxplus {

EdgeCounts EdgeCounter::count(const Graph& graph, const Plan& plan) {
  rows_.resize(graph.vertex_pools().size());
  for (std::size_t p = 0; p < rows_.size(); ++p) rows_[p].assign(graph.vertex_pools()[p]->slots(), 0);
  EdgeCounts counts;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    const int uniform_rows = pool.uniform_shape() ? pool.shape(list.edges.front()).rows : -1;
    for (const std::uint32_t edge : list.edges) {
      if (!pool.enabled(edge)) {
        ++counts.disabled;
        continue;
      }
      const int all_rows = uniform_rows >= 0 ? uniform_rows : pool.shape(edge).rows;
      const auto rows = static_cast<std::uint64_t>(weighted_rows(pool.information(edge, all_rows)));
      counts.rows += rows;
      counts.robust += pool.kernel(edge) != nullptr;
      const std::span<const std::uint32_t> slots = pool.vertex_slots(edge);
      for (std::size_t i = 0; i < slots.size(); ++i)
        rows_[pool.vertex_pool(edge, static_cast<int>(i))][slots[i]] += rows;
    }
  }
  return counts;
}

std::uint64_t EdgeCounter::undetermined(const Graph& graph, RunSystem& system) {
  const Plan& plan = system.plan();
  rows_of_.assign(plan.scalars(), 0);
  unknowns_of_.assign(plan.scalars(), 1);  // of each scalar at first
  for (const std::uint32_t i : plan.fixed_scalars) unknowns_of_[i] = 0;
  for (const std::uint32_t i : plan.held_scalars) unknowns_of_[i] = 0;
  for (const VertexList& list : plan.vertices) {
    for (std::size_t k = 0; k < list.slots.size(); ++k) {
      const std::uint32_t first = list.offsets[k], slot = list.slots[k];
      const int dim = graph.vertex_pools()[list.pool]->tangent_dim(slot);
      for (int i = 1; i < dim; ++i) unknowns_of_[first] += std::exchange(unknowns_of_[first + i], 0);
      rows_of_[first] = static_cast<double>(rows_[list.pool][slot]);
    }
  }
  const auto first_scalar = [&](std::uint32_t block) -> double& {
    return unknowns_of_[plan.structure.offset[block]];
  };
  for (const std::uint32_t block : plan.undetermined_blocks) first_scalar(block) = 0;
  if (plan.held_scalars.empty()) {  // a policy leaves the freedom as it is, so that no vertex is held
    for (const detail::GaugeFreedom& freedom : plan.freedoms) {
      const auto found = std::ranges::find(plan.block_vertex, freedom.vertex);
      if (found == plan.block_vertex.end()) continue;
      first_scalar(static_cast<std::uint32_t>(found - plan.block_vertex.begin())) -= freedom.directions;
    }
  }
  system.add_up(rows_of_, std::numeric_limits<double>::infinity());
  double undetermined = 0;
  for (std::size_t i = 0; i < rows_of_.size(); ++i)
    undetermined += std::max(0.0, unknowns_of_[i] - rows_of_[i]);
  return static_cast<std::uint64_t>(undetermined);
}

}  // namespace boxplus
