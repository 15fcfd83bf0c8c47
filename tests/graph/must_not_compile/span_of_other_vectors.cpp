// SPDX-License-Identifier: BSD-3-Clause
#include <span>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/manifold/rn.h"

struct Width {
  double error(std::span<const boxplus::Vector3> points) const { return points[1][0] - points[0][0]; }
};

void span_of_other_vectors(boxplus::Graph& graph) {
  const std::vector<boxplus::VertexHandle<Eigen::Vector2d>> points{graph.add_vertex(Eigen::Vector2d(1, 2)),
                                                                   graph.add_vertex(Eigen::Vector2d(3, 4))};
  graph.add_edge(Width{}, points);
}
