// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

void plain_vector_of_another_size(boxplus::Graph& graph) {
  graph.add_edge([](const Eigen::Vector3d& point) { return point[2]; },
                 graph.add_vertex(Eigen::Vector2d(1, 2)));
}
