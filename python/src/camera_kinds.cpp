// SPDX-License-Identifier: BSD-3-Clause
// Cameras as vertices, and the edges of images.
#include "camera_values.h"
#include "edge_kind.h"
#include "vertex_kind.h"

namespace boxplus::python {

std::vector<VertexKind> camera_vertex_kinds() {
  std::vector<VertexKind> kinds;
  detail::CameraList::for_each([&]<class Camera>() { kinds.push_back(vertex_kind<Camera>()); });
  kinds.push_back(vertex_kind<Product<SE3, BalCamera>>());
  return kinds;
}

std::vector<EdgeKind> camera_edge_kinds() {
  std::vector<EdgeKind> kinds;
  detail::CameraList::for_each([&]<class Camera>() {
    kinds.push_back(edge_kind<Reprojection<Camera>, SE3, Vector3, Camera>("Reprojection"));
  });
  kinds.push_back(edge_kind<Reprojection<BalCamera>, Product<SE3, BalCamera>, Vector3>("Reprojection"));
  return kinds;
}

}  // namespace boxplus::python
