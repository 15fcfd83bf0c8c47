// SPDX-License-Identifier: BSD-3-Clause
#include "optimize/edge_counts.h"

namespace boxplus {

EdgeCounts count_edges(const Graph& graph, const Plan& plan) {
  EdgeCounts counts;
  for (const EdgeList& list : plan.edges) {
    const detail::EdgePool& pool = *graph.edge_pools()[list.pool];
    const int uniform_rows = pool.uniform_shape() ? pool.shape(list.edges.front()).rows : -1;
    for (const std::uint32_t edge : list.edges) {
      if (!pool.enabled(edge)) {
        ++counts.disabled;
        continue;
      }
      counts.rows += static_cast<std::uint64_t>(uniform_rows >= 0 ? uniform_rows : pool.shape(edge).rows);
      counts.robust += pool.kernel(edge) != nullptr;
    }
  }
  return counts;
}

}  // namespace boxplus
