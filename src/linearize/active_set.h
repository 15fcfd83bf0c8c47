// SPDX-License-Identifier: BSD-3-Clause
// The vertices and edges that take part in one optimization.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/linearize/plan.h"
#include "linearize/gauge.h"

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

ActiveSet find_active_set(const Graph& graph, const PlanRequest& request);

}  // namespace boxplus
