// SPDX-License-Identifier: BSD-3-Clause
// The connected components of the active graph, and their parts.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/base/stop_token.h"
#include "gauge/edge_ends.h"
#include "gauge/free_motions.h"

namespace boxplus {

/// A connected component of the active graph: the moving vertices that edges join. Parameters belong to no
/// component.
struct GaugeComponent {
  std::vector<VertexSlot> vertices;
  bool anchored = false;  ///< an edge or a fixed direction ties a vertex to the world
  /// The motions that change no error while nothing is held: at most one entry for each dimension of the
  /// world.
  std::vector<FreeMotions> free;
  std::vector<VertexSlot> moved;  ///< the vertices that take part in these motions
};

/// A component while it is examined.
struct Component : GaugeComponent {
  std::vector<EdgeSlot> edges;
  std::vector<EdgeSlot> anchors;  // the edges with one moving vertex, or with a fixed vertex
  int most_anchor_rows = 0;       // the most rows of an edge with exactly one moving vertex
  bool only_rigid = true;         // whether all edges are of types that measure poses relative to each other
  bool bounded = false;           // whether an entry of a vertex has bounds
  // The vertices that its edges share with other components, such as the calibration of a sensor that made
  // several maps. They do not move with the world. Only directions of such a component are held, so that
  // every step checks them, because edges may resist at other values of these vertices.
  std::vector<VertexSlot> left_out;
  std::vector<VertexSlot> shared;  // those of `left_out` that are listed with this component
};

/// Throws Stopped when the token is raised.
class ComponentFinder {
 public:
  /// `movable` has a flag for each slot of each vertex pool. All arguments must outlive this object.
  ComponentFinder(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable,
                  const EdgeEnds& ends, const StopToken& stop)
      : graph_(graph), movable_(movable), ends_(ends), stop_(stop) {}

  /// The components that these edges join, which are listed by edge pool. O(edges).
  std::vector<Component> find(const std::vector<std::vector<std::uint32_t>>& active_edges);
  /// Whether edges of several components have a vertex, by GraphView::number().
  std::vector<std::uint8_t> find_shared(const std::vector<Component>& components) const;
  /// The components of a component from which vertices are left out. The first one lists these. Returns
  /// nothing if there is only one, or if one of them is a single vertex.
  std::vector<Component> parts_without(const Component& whole, const std::vector<VertexSlot>& left_out);
  /// Whether each vertex of a component has at least as many rows of edges as unknowns. If it has fewer,
  /// holding one of the unknowns may not hold the world: a point that one camera sees may move towards it.
  std::vector<bool> find_determined(const Component& component);

 private:
  static constexpr std::uint32_t kNone = GraphView::kNone;

  void add_vertex(VertexSlot v, Component& component) const;
  void add_edge(EdgeSlot edge, int moving, Component& component) const;
  /// Numbers the vertices of a component for local().
  void number_vertices(const Component& component);
  std::uint32_t local(VertexSlot v) const { return local_[ends_.number(v)]; }

  const Graph& graph_;
  const std::vector<std::vector<std::uint8_t>>& movable_;
  const EdgeEnds& ends_;
  const StopToken& stop_;
  std::vector<std::uint32_t> local_;  // of the vertices of a component, by GraphView::number()
};

}  // namespace boxplus
