// SPDX-License-Identifier: BSD-3-Clause
// The edges of images whose cameras have known parameters.
#include "camera_values.h"
#include "edge_kind.h"

namespace boxplus::python {

std::vector<EdgeKind> known_camera_edge_kinds() {
  std::vector<EdgeKind> kinds;
  detail::CameraList::for_each([&]<class Camera>() {
    kinds.push_back(edge_kind<CalibratedReprojection<Camera>, SE3, Vector3>("CalibratedReprojection"));
  });
  return kinds;
}

}  // namespace boxplus::python
