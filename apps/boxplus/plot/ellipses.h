// SPDX-License-Identifier: BSD-3-Clause
// Uncertainty ellipses: where a pose or a point lies with 95 %.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "plot/axes.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Adds the 95 % ellipses of all poses and points of the scene's graph, at the estimates and relative to what
/// holds it, and makes some room for them. Throws InvalidArgument, with the name of the graph and the vertex,
/// if one is not determined.
void add_ellipses(Scene& scene, const Graph& graph, const View& view, const std::string& name);

/// Those that can be told apart, the last pose first: not smaller than a few pixels (of `pixel` metres), and
/// not over one another, unless one is of a pose and one of a point. At most a few hundred.
std::vector<Ellipse> legible(const std::vector<Ellipse>& ellipses, double pixel);

/// Draws the parts that lie within a box; lines are `width` pixels wide.
void draw_ellipses(const std::vector<Ellipse>& ellipses, const PlaneMap& map, const Box& box, double width,
                   Canvas& canvas);

}  // namespace boxplus::app
