// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/edge_roles.h"

#include <algorithm>

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
  for (const VertexRef& vertex : graph.all_vertices()) {
    if (role_of(graph, vertex) == VertexRole::kPose) rank_.emplace(graph.id(vertex), rank_.size());
  }
}

EdgeRole EdgeRoles::operator()(EdgeRef edge) const {
  std::size_t vertices = 0, landmarks = 0;
  std::vector<std::size_t> ranks;
  for (const VertexRef& vertex : graph_->vertices(edge)) {
    const detail::VertexPool& pool = *graph_->vertex_pools()[vertex.pool];
    if (pool.parameter(vertex.slot)) continue;
    ++vertices;
    const VertexRole role = role_of(*graph_, vertex);
    landmarks += role == VertexRole::kLandmark;
    if (role == VertexRole::kPose) ranks.push_back(rank_.at(pool.id(vertex.slot)));
  }
  if (vertices == 1) return EdgeRole::kPrior;
  if (landmarks > 0) return EdgeRole::kObservation;
  if (ranks.size() < 2) return EdgeRole::kOther;
  const auto [first, last] = std::minmax_element(ranks.begin(), ranks.end());
  return *last - *first < ranks.size() ? EdgeRole::kOdometry : EdgeRole::kLoopClosure;
}

}  // namespace boxplus::viewer
