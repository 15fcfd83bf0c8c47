// SPDX-License-Identifier: BSD-3-Clause
// What holds each component of the active graph in place, and what to hold for those that nothing holds.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/linearize/plan.h"

namespace boxplus {

/// One direction of a vertex' tangent.
struct TangentDirection {
  VertexRef vertex;
  int component;
};

struct Gauge {
  std::vector<GaugeVertex> held;
  std::vector<TangentDirection> held_directions;  ///< of vertices that are not held whole
  std::vector<GaugeFreedom> freedoms;
  /// One vertex of each component that nothing anchors and whose freedom, if any, is not one of similarities.
  std::vector<VertexRef> loose;
};

/// Finds the gauge freedom of every component of the active edges (slots per edge pool). `movable`: per
/// vertex pool and slot. Components of ready-made relative poses and priors are decided by counting; all
/// others by whether a similarity of the world changes an error (similarity_freedom.h). Throws Stopped once
/// `stop` is raised.
Gauge find_gauge(const Graph& graph, const std::vector<std::vector<std::uint32_t>>& active_edges,
                 const std::vector<std::vector<std::uint8_t>>& movable, GaugePolicy policy,
                 const StopToken& stop);

}  // namespace boxplus
