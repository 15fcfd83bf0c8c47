// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/edge_roles.h"

#include <algorithm>
#include <unordered_set>
#include <vector>

namespace boxplus::viewer {

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

EdgeRoles::EdgeRoles(const Graph& graph) : graph_(&graph) {
  std::unordered_set<Id> last,
      other;  // where the vertices are in edges of three or more vertices, and in all others
  for (const EdgeRef& edge : graph.all_edges()) {
    std::vector<Id> ids;
    for (const VertexRef& vertex : graph.vertices(edge)) {
      if (!graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) ids.push_back(graph.id(vertex));
    }
    if (ids.size() < 3) {
      other.insert(ids.begin(), ids.end());
    } else {
      last.insert(ids.back());
      other.insert(ids.begin(), ids.end() - 1);
    }
  }
  for (const VertexRef& vertex : graph.all_vertices()) {
    const Id id = graph.id(vertex);
    const bool is_sensor = last.contains(id) && !other.contains(id);
    if (role_of(graph, vertex) == VertexRole::kPose && !is_sensor) rank_.emplace(id, rank_.size());
  }
}

EdgeRole EdgeRoles::operator()(EdgeRef edge) const {
  std::size_t vertices = 0, landmarks = 0, others = 0;
  std::vector<std::size_t> ranks;
  for (const VertexRef& vertex : graph_->vertices(edge)) {
    const detail::VertexPool& pool = *graph_->vertex_pools()[vertex.pool];
    if (pool.parameter(vertex.slot)) continue;
    ++vertices;
    const VertexRole role = role_of(*graph_, vertex);
    landmarks += role == VertexRole::kLandmark;
    others += role == VertexRole::kOther;
    if (role != VertexRole::kPose) continue;
    if (const auto rank = rank_.find(pool.id(vertex.slot)); rank != rank_.end())
      ranks.push_back(rank->second);
  }
  if (vertices == 1) return EdgeRole::kPrior;
  if (landmarks > 0 || (others > 0 && ranks.size() == 1)) return EdgeRole::kObservation;
  if (ranks.size() < 2) return EdgeRole::kOther;
  const auto [first, last] = std::minmax_element(ranks.begin(), ranks.end());
  return *last - *first < ranks.size() ? EdgeRole::kOdometry : EdgeRole::kLoopClosure;
}

}  // namespace boxplus::viewer
