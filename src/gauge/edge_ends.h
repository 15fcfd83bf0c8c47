// SPDX-License-Identifier: BSD-3-Clause
// The vertices of active edges, and which of them move.
#pragma once

#include <cstdint>
#include <vector>

#include "graph/graph_view.h"

namespace boxplus {

/// An active edge.
struct EdgeSlot {
  std::uint32_t pool, slot;
};
/// A vertex that may move.
struct VertexSlot {
  std::uint32_t pool, slot;
  bool operator==(const VertexSlot&) const = default;
};

/// Finds the moving vertices of an edge. Parameters count neither as moving nor as fixed.
class EdgeEnds {
 public:
  enum class End : std::uint8_t { kParameter, kFixed, kMoving };

  /// `movable` has a flag for each slot of each vertex pool.
  EdgeEnds(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable) : view_(graph) {
    ends_.reserve(view_.numbers());
    for (std::size_t p = 0; p < movable.size(); ++p) {
      const detail::VertexPool& pool = *graph.vertex_pools()[p];
      for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
        ends_.push_back(pool.parameter(slot)    ? End::kParameter
                        : movable[p][slot] != 0 ? End::kMoving
                                                : End::kFixed);
      }
    }
  }

  /// Calls f(vertex, end, position) for each vertex of the edge.
  template <class F>
  void for_each(EdgeSlot edge, F&& f) const {
    view_.for_each_vertex(edge.pool, edge.slot,
                          [&](std::uint32_t pool, std::uint32_t slot, std::size_t position) {
                            f(VertexSlot{pool, slot}, ends_[view_.number(pool, slot)], position);
                          });
  }
  /// Calls f(vertex, position) for each moving vertex of the edge.
  template <class F>
  void for_each_moving(EdgeSlot edge, F&& f) const {
    for_each(edge, [&](VertexSlot v, End end, std::size_t position) {
      if (end == End::kMoving) f(v, position);
    });
  }

  const GraphView& view() const { return view_; }
  std::uint32_t number(VertexSlot v) const { return view_.number(v.pool, v.slot); }

 private:
  GraphView view_;
  std::vector<End> ends_;  // by number
};

}  // namespace boxplus
