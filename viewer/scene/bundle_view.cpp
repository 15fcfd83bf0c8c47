// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/bundle_view.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "boxplus/base/matrix.h"
#include "io/ply/camera_pyramids.h"

namespace boxplus::viewer {

bool is_bundle(const Graph& graph) {
  if (graph.edge_count() == 0) return false;
  return std::all_of(graph.edge_pools().begin(), graph.edge_pools().end(),
                     [](const auto& pool) { return pool->alive_count() == 0 || is_reprojection(*pool); });
}

std::array<double, 9> leveling(const Graph& graph) {
  const std::vector<int> directions = view_directions(graph);
  Vector3 right(0, 0, 0), forward(0, 0, 0), up(0, 0, 0);
  for (const VertexRef& vertex : graph.all_vertices()) {
    const int direction = directions[vertex.pool];
    detail::Frame frame;
    if (direction == 0 || !graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame)) continue;
    const auto column = [&](std::size_t axis) {
      return Vector3(frame.rotation[axis], frame.rotation[3 + axis], frame.rotation[6 + axis]);
    };
    right += column(0);
    up -= direction * column(1);
    forward += direction * column(2);
  }
  constexpr double kLeast = 1e-6;
  if (!(up.norm() > kLeast)) return {1, 0, 0, 0, 1, 0, 0, 0, 1};
  up.normalize();
  forward -= up.dot(forward) * up;
  // If the cameras look in all directions, any horizontal direction will do.
  if (!(forward.norm() > kLeast)) forward = up.cross(right);
  if (!(forward.norm() > kLeast)) forward = up.unitOrthogonal();
  forward.normalize();
  right = forward.cross(up);
  return {right[0], right[1], right[2], forward[0], forward[1], forward[2], up[0], up[1], up[2]};
}

}  // namespace boxplus::viewer
