// SPDX-License-Identifier: BSD-3-Clause
// The view of a graph on which searches in it stand: numbers of vertices, ends of edges, roles, components.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/paced_stop.h"
#include "boxplus/graph/graph.h"

namespace boxplus {

/// Numbers the slots of all vertex pools of a graph, one pool after the other. Numbers allow the use of
/// arrays instead of maps. While a view exists, the structure of its graph must not change. O(pools) time.
class GraphView {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  explicit GraphView(const Graph& graph);

  const Graph& graph() const { return *graph_; }
  /// All vertices have numbers below this. (So do slots without a vertex.)
  std::uint32_t numbers() const { return first_.back(); }
  std::uint32_t number(std::uint32_t pool, std::uint32_t slot) const { return first_[pool] + slot; }
  std::uint32_t number(VertexRef vertex) const { return number(vertex.pool, vertex.slot); }
  std::uint32_t pool_of(std::uint32_t number) const;
  std::uint32_t slot_of(std::uint32_t number) const { return number - first_[pool_of(number)]; }
  const detail::VertexPool& vertices_of(std::uint32_t number) const {
    return *graph_->vertex_pools()[pool_of(number)];
  }

  /// Calls f(pool, slot, position) for each vertex of an edge, also for parameters.
  template <class F>
  void for_each_vertex(std::uint32_t edge_pool, std::uint32_t edge, F&& f) const {
    const detail::EdgePool& pool = *graph_->edge_pools()[edge_pool];
    const std::span<const std::uint32_t> slots = pool.vertex_slots(edge);
    for (std::size_t i = 0; i < slots.size(); ++i)
      f(pool.vertex_pool(edge, static_cast<int>(i)), slots[i], i);
  }
  /// Calls f(number) for each vertex of an edge that is no parameter.
  template <class F>
  void for_each_end(std::uint32_t edge_pool, std::uint32_t edge, F&& f) const {
    for_each_vertex(edge_pool, edge, [&](std::uint32_t pool, std::uint32_t slot, std::size_t) {
      if (!graph_->vertex_pools()[pool]->parameter(slot)) f(number(pool, slot));
    });
  }
  template <class F>
  void for_each_end(EdgeRef edge, F&& f) const {
    for_each_end(edge.pool, edge.slot, f);
  }
  /// The first end of an edge, or kNone if it has none.
  std::uint32_t first_end(EdgeRef edge) const;
  /// Makes one set of the ends of an edge.
  void join_ends(std::uint32_t edge_pool, std::uint32_t edge, DisjointSets& sets) const;
  /// The vertices that edges connect, by number.
  DisjointSets components() const;

 private:
  const Graph* graph_;
  std::vector<std::uint32_t> first_;  // the first number of each pool, and of none
};

enum class VertexRole : std::uint8_t { kPose, kLandmark, kOther };
/// A parameter is kOther.
VertexRole role_of(const Graph& graph, VertexRef vertex);

enum class EdgeRole : std::uint8_t {
  kOdometry,     ///< an edge between poses that are neighbors in the trajectory, which is sorted by id
  kLoopClosure,  ///< an edge between other poses of the trajectory
  kObservation,  ///< an edge with a landmark, or of one pose with something else, such as a plane
  kPrior,        ///< an edge with only one vertex
  kOther
};
inline constexpr std::size_t kEdgeRoles = 5;

/// Returns the name of a role for `count` edges, such as "loop closure" or "loop closures".
std::string_view name_of(EdgeRole role, std::size_t count);

/// The trajectory of a graph, and the roles of its edges. A pose that is always the last of three or more
/// vertices is that of a sensor on the robot, and does not belong to the trajectory. The constructor takes
/// O(n log n) time, and throws Stopped when the token is raised.
class EdgeRoles {
 public:
  explicit EdgeRoles(const Graph& graph, const StopToken& stop = {});

  const GraphView& view() const { return view_; }
  /// The poses of the trajectory, sorted by id.
  std::span<const VertexRef> trajectory() const { return trajectory_; }
  /// The position of a pose in trajectory(), or GraphView::kNone.
  std::uint32_t rank(std::uint32_t number) const { return rank_[number]; }
  std::uint32_t rank(VertexRef vertex) const { return rank_[view_.number(vertex)]; }
  EdgeRole operator()(EdgeRef edge) const;

 private:
  std::vector<std::uint8_t> find_sensors(PacedStop& pace) const;

  GraphView view_;
  std::vector<VertexRef> trajectory_;
  std::vector<std::uint32_t> rank_;  // by number
};

}  // namespace boxplus
