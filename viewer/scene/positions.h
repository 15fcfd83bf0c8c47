// SPDX-License-Identifier: BSD-3-Clause
// The positions and orientations of the vertices of a graph.
#pragma once

#include <vector>

#include "boxplus/graph/graph.h"
#include "viewer/scene/structure.h"

namespace boxplus::viewer {

struct Positions {
  /// x, y, z of each drawn vertex relative to Structure::center, in meters. z is 0 in the plane. All are NaN
  /// if the vertex is not finite, or too far away for a float.
  std::vector<float> points;
  std::vector<float> orientations;  ///< x, y, z, w of the quaternion T_world_body of each pose and camera
};

/// Reads the estimates of `graph`, which must have the structure `structure`. O(vertices).
Positions read_positions(const Graph& graph, const Structure& structure);

}  // namespace boxplus::viewer
