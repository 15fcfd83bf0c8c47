// SPDX-License-Identifier: BSD-3-Clause
// The cameras, images, points and observations of a graph of bundle adjustment.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/model/bal_vertex.h"
#include "io/model/camera_types.h"

namespace boxplus {

/// One reprojection error. The camera of a BAL image is the vertex of the image. On a rig, the vertex of the
/// image is T_world_rig, and the offset is T_rig_camera.
struct PixelObservation {
  VertexRef image, point, camera;
  std::optional<VertexRef> offset;
  Vector2 pixel;
};

class GraphRoles {
 public:
  enum class Role : std::uint8_t { kCamera, kImage, kBalImage, kPoint, kOther };

  explicit GraphRoles(const Graph& graph);

  const Graph& graph() const { return graph_; }
  Role role(VertexRef vertex) const { return roles_[vertex.pool]; }
  /// Throws InvalidArgument if the vertex has no role in bundle adjustment.
  void require_role(VertexRef vertex) const;
  /// None if the edge is no reprojection error.
  std::optional<PixelObservation> observation(EdgeRef edge) const;

 private:
  const Graph& graph_;
  std::vector<Role> roles_;               // by vertex pool
  std::vector<const CameraType*> types_;  // by vertex pool; nullptr if it has no cameras
};

/// Throws InvalidArgument: `what` cannot be part of a COLMAP model.
[[noreturn]] void refuse_for_colmap(const std::string& what);

}  // namespace boxplus
