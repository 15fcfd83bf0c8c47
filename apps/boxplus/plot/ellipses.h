// SPDX-License-Identifier: BSD-3-Clause
// Uncertainty ellipses: regions that contain a pose or a point with 95 % probability.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "plot/axes.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Adds the 95 % ellipses of all poses and points of the scene's graph, and makes some room for them. They
/// are computed at the estimates, relative to the vertices that hold the graph in place. Throws
/// InvalidArgument, with the name of the graph and the vertex, if a vertex is undetermined.
void add_ellipses(Scene& scene, const Graph& graph, const View& view, const std::string& name);

/// The ellipses that can be told apart, the last pose first. Leaves out those smaller than a few pixels (of
/// `pixel` meters), and those that lie over another, unless one is of a pose and one of a point. At most a
/// few hundred.
std::vector<Ellipse> legible(const std::vector<Ellipse>& ellipses, double pixel);

/// Draws the parts of the ellipses inside a box; lines are `width` pixels wide.
void draw_ellipses(const std::vector<Ellipse>& ellipses, const PlaneMap& map, const Box& box, double width,
                   Canvas& canvas);

}  // namespace boxplus::app
