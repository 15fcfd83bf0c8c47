// SPDX-License-Identifier: BSD-3-Clause
// The vertices of active edges, and which of them move.
#pragma once

#include <cstdint>
#include <vector>

#include "boxplus/graph/graph.h"

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
  EdgeEnds(const Graph& graph, const std::vector<std::vector<std::uint8_t>>& movable) : graph_(graph) {
    for (std::size_t p = 0; p < movable.size(); ++p) {
      const detail::VertexPool& pool = *graph.vertex_pools()[p];
      first_.push_back(count_);
      count_ += pool.slots();
      std::vector<End>& ends = ends_.emplace_back(movable[p].size());
      for (std::uint32_t slot = 0; slot < ends.size(); ++slot) {
        ends[slot] = pool.parameter(slot)    ? End::kParameter
                     : movable[p][slot] != 0 ? End::kMoving
                                             : End::kFixed;
      }
    }
  }

  /// Calls f(vertex, end, position) for each vertex of the edge.
  template <class F>
  void for_each(EdgeSlot edge, F&& f) const {
    const detail::EdgePool& pool = *graph_.edge_pools()[edge.pool];
    const auto slots = pool.vertex_slots(edge.slot);
    for (std::size_t i = 0; i < slots.size(); ++i) {
      const std::uint32_t p = pool.vertex_pool(edge.slot, static_cast<int>(i));
      f(VertexSlot{p, slots[i]}, ends_[p][slots[i]], i);
    }
  }
  /// Calls f(vertex, position) for each moving vertex of the edge.
  template <class F>
  void for_each_moving(EdgeSlot edge, F&& f) const {
    for_each(edge, [&](VertexSlot v, End end, std::size_t position) {
      if (end == End::kMoving) f(v, position);
    });
  }

  /// The number of a vertex among all slots of all pools, of which there are slots().
  std::uint32_t index(VertexSlot v) const { return first_[v.pool] + v.slot; }
  std::size_t slots() const { return count_; }

 private:
  const Graph& graph_;
  std::vector<std::vector<End>> ends_;  // per slot of each vertex pool
  std::vector<std::uint32_t> first_;    // the index of the first slot of each vertex pool
  std::uint32_t count_ = 0;
};

}  // namespace boxplus
