// SPDX-License-Identifier: BSD-3-Clause
// Several values in one vertex: a pose with a velocity, the biases of an inertial sensor, or a second pose.
#include "vertex_kind.h"

namespace boxplus::python {

std::vector<VertexKind> product_vertex_kinds() {
  using Vector6 = Vector<double, 6>;
  return {vertex_kind<Product<SE2, Vector2>>(),
          vertex_kind<Product<SE2, Vector3>>(),
          vertex_kind<Product<SE2, SE2>>(),
          vertex_kind<Product<SO3, Vector3>>(),
          vertex_kind<Product<SE3, Vector3>>(),
          vertex_kind<Product<SE3, Vector6>>(),
          vertex_kind<Product<SE3, Vector3, Vector6>>(),
          vertex_kind<Product<SE3, SE3>>()};
}

}  // namespace boxplus::python
