// SPDX-License-Identifier: BSD-3-Clause
// The vertices and edges that take part in one optimization.
#pragma once

#include <cstdint>
#include <vector>

#include "base/paced_stop.h"
#include "gauge/gauge.h"
#include "plan/edge_targets.h"
#include "plan/plan.h"

namespace boxplus {

struct ActiveSet {
  static constexpr std::uint32_t kInactive = 0xFFFFFFFFu;

  /// The slots of the active edges of each edge pool, ascending.
  std::vector<std::vector<std::uint32_t>> edges;
  /// The block of each vertex in H, or kInactive, by vertex pool and slot.
  std::vector<std::vector<std::uint32_t>> block;
  std::vector<VertexRef> block_vertex;
  std::uint32_t eliminated_blocks = 0;
  Gauge gauge;
};

/// Applies bounds to the gauge.
ActiveSet find_active_set(const Graph& graph, const PlanRequest& request);
ActiveSet find_active_set(const Graph& graph, const PlanRequest& request, GaugeBounds bounds);

/// Like make_plan(graph, request), which applies bounds to the gauge.
Plan make_plan(const Graph& graph, const PlanRequest& request, GaugeBounds bounds);

/// Calls f(pool, edge, blocks) for each active edge. `blocks` are those of its vertices, as edge_blocks()
/// lists them.
template <class F>
void for_each_active_edge(const Graph& graph, const ActiveSet& active, PacedStop& pace, F&& f) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t p = 0; p < active.edges.size(); ++p) {
    for (std::uint32_t edge : active.edges[p]) {
      pace.step();
      edge_blocks(*graph.edge_pools()[p], edge, active.block, blocks);
      f(p, edge, blocks);
    }
  }
}

}  // namespace boxplus
