// SPDX-License-Identifier: BSD-3-Clause
#include "plan/estimates.h"

namespace boxplus {

void Estimates::take(const Graph& graph, const Plan& plan) {
  parts_.resize(plan.vertices.size());
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const VertexList& list = plan.vertices[k];
    Part& part = parts_[k];
    if (part.pool != list.pool) part.estimates.reset();
    part.pool = list.pool;
    graph.vertex_pools()[list.pool]->save(list.slots, part.estimates);
  }
}

void Estimates::put_back(Graph& graph, const Plan& plan) const {
  for (std::size_t k = 0; k < parts_.size(); ++k)
    graph.vertex_pools()[parts_[k].pool]->restore(plan.vertices[k].slots, *parts_[k].estimates);
}

}  // namespace boxplus
