// SPDX-License-Identifier: BSD-3-Clause
#include "graph/snapshot.h"

namespace boxplus::outliers {

void Snapshot::take(const Graph& graph) {
  const auto& pools = graph.vertex_pools();
  parts_.resize(pools.size());
  for (Part& part : parts_) part.slots.clear();
  for (const VertexRef& vertex : graph.all_vertices()) parts_[vertex.pool].slots.push_back(vertex.slot);
  for (std::size_t k = 0; k < parts_.size(); ++k) pools[k]->save(parts_[k].slots, parts_[k].estimates);
}

void Snapshot::put_back(const Graph& graph) const {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    graph.vertex_pools()[k]->restore(parts_[k].slots, *parts_[k].estimates);
}

}  // namespace boxplus::outliers
