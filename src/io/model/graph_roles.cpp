// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/graph_roles.h"

#include <fmt/format.h>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

template <class T>
bool holds(const detail::VertexPool& pool) {
  return dynamic_cast<const detail::TypedVertexPool<T>*>(&pool) != nullptr;
}

GraphRoles::Role role_of(const detail::VertexPool& pool, const CameraType* type) {
  using Role = GraphRoles::Role;
  return type                     ? Role::kCamera
         : holds<SE3>(pool)       ? Role::kImage
         : holds<BalVertex>(pool) ? Role::kBalImage
         : holds<Vector3>(pool)   ? Role::kPoint
                                  : Role::kOther;
}

const Vector2* bal_pixel(const Graph& graph, EdgeRef edge) {
  using Pool = detail::TypedEdgePool<BalEdge, BalVertex, Vector3>;
  const auto* pool = dynamic_cast<const Pool*>(graph.edge_pools()[edge.pool].get());
  return pool ? &pool->value(edge.slot).measurement : nullptr;
}

}  // namespace

void refuse_for_colmap(const std::string& what) {
  throw InvalidArgument(
      "cannot write a COLMAP model: expected cameras of COLMAP's models, poses SE3, points Vector3 and edges "
      "Reprojection between them, or a BAL problem, got " +
      what);
}

GraphRoles::GraphRoles(const Graph& graph) : graph_(graph) {
  for (const auto& pool : graph.vertex_pools()) {
    types_.push_back(camera_type_of(*pool));
    roles_.push_back(role_of(*pool, types_.back()));
  }
}

void GraphRoles::require_role(VertexRef vertex) const {
  if (role(vertex) != Role::kOther) return;
  refuse_for_colmap(fmt::format("vertex {} of type {}", graph_.id(vertex),
                                graph_.vertex_pools()[vertex.pool]->type_name()));
}

std::optional<PixelObservation> GraphRoles::observation(EdgeRef edge) const {
  const std::vector<VertexRef> vertices = graph_.vertices(edge);
  const bool is_on_rig = vertices.size() == 4;
  const CameraType* type = vertices.size() == 3 || is_on_rig ? types_[vertices.back().pool] : nullptr;
  const Vector2* pixel = type ? type->pixel(graph_, edge) : bal_pixel(graph_, edge);
  if (!pixel) return std::nullopt;
  return PixelObservation{vertices[0], vertices[1], type ? vertices.back() : vertices[0],
                          is_on_rig ? std::optional(vertices[2]) : std::nullopt, *pixel};
}

}  // namespace boxplus
