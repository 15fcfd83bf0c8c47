// SPDX-License-Identifier: BSD-3-Clause
// The gauge freedom of the components of the active graph, and the vertices and directions to hold fixed.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/gauge/gauge.h"
#include "gauge/components.h"

namespace boxplus {

/// One direction of a vertex's tangent.
struct TangentDirection {
  VertexRef vertex;
  int component;
};

struct Gauge {
  std::vector<GaugeComponent> components;
  std::vector<detail::GaugeVertex> held;
  std::vector<TangentDirection> held_directions;  ///< held directions of vertices that are not fully held
  std::vector<detail::GaugeFreedom> freedoms;
  /// One vertex of each component that has no anchor, but in which every similarity changes an error. Such a
  /// component may have gauge freedom of another kind.
  std::vector<VertexRef> loose;
};

/// Whether bounds of vertices (Graph::set_bounds()) matter for the gauge. If they do, nothing of a component
/// with bounds is held, because the limits would then refer to what is held.
enum class GaugeBounds : std::uint8_t { kApply, kIgnore };

/// Finds the gauge freedom of every component of the active graph. `active_edges` lists the slots of each
/// edge pool. `movable` has a flag for each slot of each vertex pool. If the types of all edges in a
/// component only measure relative poses or priors, it is usually enough to count the rows of its priors. For
/// all other components, tests whether a similarity of the world changes an error (similarity_freedom.h). If
/// some rows of an Ω are zero, these rows measure nothing.
/// Throws Stopped when `stop` is raised.
Gauge find_gauge(const Graph& graph, const std::vector<std::vector<std::uint32_t>>& active_edges,
                 const std::vector<std::vector<std::uint8_t>>& movable, GaugePolicy policy,
                 const StopToken& stop, GaugeBounds bounds = GaugeBounds::kApply);

}  // namespace boxplus
