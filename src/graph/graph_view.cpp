// SPDX-License-Identifier: BSD-3-Clause
#include "graph/graph_view.h"

#include <algorithm>

namespace boxplus {

GraphView::GraphView(const Graph& graph) : graph_(&graph), first_{0} {
  for (const auto& pool : graph.vertex_pools()) first_.push_back(first_.back() + pool->slots());
}

std::uint32_t GraphView::pool_of(std::uint32_t number) const {
  return static_cast<std::uint32_t>(std::upper_bound(first_.begin(), first_.end(), number) - first_.begin() -
                                    1);
}

std::uint32_t GraphView::first_end(EdgeRef edge) const {
  std::uint32_t first = kNone;
  for_each_end(edge, [&](std::uint32_t number) {
    if (first == kNone) first = number;
  });
  return first;
}

void GraphView::join_ends(std::uint32_t edge_pool, std::uint32_t edge, DisjointSets& sets) const {
  std::uint32_t first = kNone;
  for_each_end(edge_pool, edge, [&](std::uint32_t number) {
    if (first == kNone) first = number;
    sets.join(first, number);
  });
}

DisjointSets GraphView::components() const {
  DisjointSets sets(numbers());
  for (std::uint32_t p = 0; p < graph_->edge_pools().size(); ++p) {
    const detail::EdgePool& pool = *graph_->edge_pools()[p];
    for (std::uint32_t edge = 0; edge < pool.slots(); ++edge) {
      if (pool.alive(edge)) join_ends(p, edge, sets);
    }
  }
  return sets;
}

VertexRole role_of(const Graph& graph, VertexRef vertex) {
  detail::Frame frame;
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  if (pool.parameter(vertex.slot) || !pool.get_frame(vertex.slot, frame)) return VertexRole::kOther;
  return frame.has_rotation ? VertexRole::kPose : VertexRole::kLandmark;
}

std::string_view name_of(EdgeRole role, std::size_t count) {
  switch (role) {
    case EdgeRole::kOdometry:
      return "odometry";
    case EdgeRole::kLoopClosure:
      return count == 1 ? "loop closure" : "loop closures";
    case EdgeRole::kObservation:
      return count == 1 ? "observation" : "observations";
    case EdgeRole::kPrior:
      return count == 1 ? "prior" : "priors";
    default:
      return count == 1 ? "other" : "others";
  }
}

EdgeRoles::EdgeRoles(const Graph& graph, const StopToken& stop)
    : view_(graph), rank_(view_.numbers(), GraphView::kNone) {
  PacedStop pace(stop);
  const std::vector<std::uint8_t> is_sensor = find_sensors(pace);
  for (std::uint32_t p = 0; p < graph.vertex_pools().size(); ++p) {
    const detail::VertexPool& pool = *graph.vertex_pools()[p];
    for (std::uint32_t slot = 0; slot < pool.slots(); ++slot) {
      pace.step();
      const VertexRef vertex{p, slot, pool.generation(slot)};
      if (pool.alive(slot) && !is_sensor[view_.number(vertex)] && role_of(graph, vertex) == VertexRole::kPose)
        trajectory_.push_back(vertex);
    }
  }
  std::ranges::sort(trajectory_, [&](const VertexRef& a, const VertexRef& b) {
    pace.step();
    return graph.id(a) < graph.id(b);
  });
  for (std::uint32_t rank = 0; rank < trajectory_.size(); ++rank)
    rank_[view_.number(trajectory_[rank])] = rank;
}

/// Whether each vertex is the last of three or more vertices of edges, and nothing else, by number.
std::vector<std::uint8_t> EdgeRoles::find_sensors(PacedStop& pace) const {
  enum Place : std::uint8_t { kLast = 1, kOther = 2 };
  std::vector<std::uint8_t> places(view_.numbers(), 0);
  std::vector<std::uint32_t> ends;
  const auto pools = view_.graph().edge_pools();
  for (std::uint32_t p = 0; p < pools.size(); ++p) {
    for (std::uint32_t edge = 0; edge < pools[p]->slots(); ++edge) {
      pace.step();
      if (!pools[p]->alive(edge)) continue;
      ends.clear();
      view_.for_each_end(p, edge, [&](std::uint32_t number) { ends.push_back(number); });
      for (const std::uint32_t number : ends)
        places[number] |= ends.size() >= 3 && number == ends.back() ? kLast : kOther;
    }
  }
  for (std::uint8_t& place : places) place = place == kLast;
  return places;
}

EdgeRole EdgeRoles::operator()(EdgeRef edge) const {
  std::size_t vertices = 0, landmarks = 0, others = 0, poses = 0;
  std::uint32_t first = GraphView::kNone, last = 0;
  const Graph& graph = view_.graph();
  view_.for_each_vertex(edge.pool, edge.slot, [&](std::uint32_t pool, std::uint32_t slot, std::size_t) {
    if (graph.vertex_pools()[pool]->parameter(slot)) return;
    ++vertices;
    const std::uint32_t rank = this->rank(view_.number(pool, slot));
    const VertexRole role = rank == GraphView::kNone ? role_of(graph, {pool, slot, 0}) : VertexRole::kPose;
    landmarks += role == VertexRole::kLandmark;
    others += role == VertexRole::kOther;
    if (rank == GraphView::kNone) return;
    ++poses;
    first = std::min(first, rank);
    last = std::max(last, rank);
  });
  if (vertices == 1) return EdgeRole::kPrior;
  if (landmarks > 0 || (others > 0 && poses == 1)) return EdgeRole::kObservation;
  if (poses < 2) return EdgeRole::kOther;
  return last - first < poses ? EdgeRole::kOdometry : EdgeRole::kLoopClosure;
}

}  // namespace boxplus
