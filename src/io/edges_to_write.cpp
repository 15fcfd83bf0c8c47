// SPDX-License-Identifier: BSD-3-Clause
#include "io/edges_to_write.h"

namespace boxplus {

std::vector<EdgeRef> edges_to_write(const GraphFileView& file) {
  if (file.edges.empty()) return file.graph.all_edges();
  std::vector<EdgeRef> edges(file.edges.begin(), file.edges.end());
  std::vector<std::vector<bool>> listed;
  for (const auto& pool : file.graph.edge_pools()) listed.emplace_back(pool->slots());
  for (EdgeRef& edge : edges) {
    if (!file.graph.contains(edge) || listed[edge.pool][edge.slot]) {
      edge = {};
    } else {
      listed[edge.pool][edge.slot] = true;
    }
  }
  for (const EdgeRef& edge : file.graph.all_edges()) {
    if (!listed[edge.pool][edge.slot]) edges.push_back(edge);
  }
  return edges;
}

}  // namespace boxplus
