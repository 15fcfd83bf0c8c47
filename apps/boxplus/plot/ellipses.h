// SPDX-License-Identifier: BSD-3-Clause
// Uncertainty ellipses: regions that contain a pose or a point with 95 % probability.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "boxplus/graph/frame.h"
#include "plot/axes.h"
#include "plot/scene.h"

namespace boxplus::app {

/// Returns the projection of the 95 % ellipse around a position with this covariance, which is dimension ×
/// dimension, in the frame of the world.
Ellipse ellipse_of(const detail::Frame& frame, const Eigen::MatrixXd& covariance, const View& view,
                   double time);

/// Makes some room in the scene for its ellipses.
void enclose_ellipses(Scene& scene);

/// Adds the 95 % ellipses of all poses and points of `graph` to its scene, and enlarges the scene to make
/// some room for them. The covariances are computed at the estimates, relative to the vertices that hold the
/// graph in place. Throws InvalidArgument if a vertex is undetermined. The message names the graph and the
/// vertex.
void add_ellipses(Scene& scene, const Graph& graph, const View& view, const std::string& name);

/// Returns the ellipses that can be told apart, beginning with the vertex with the highest id. Leaves out
/// ellipses that are smaller than a few pixels, and ellipses that lie over an earlier ellipse of the same
/// kind (pose or point). `pixel` is the size of a pixel in meters. Returns at most a few hundred ellipses.
std::vector<Ellipse> legible(const std::vector<Ellipse>& ellipses, double pixel);

/// Draws the parts of the ellipses inside a box. The lines are `width` pixels wide.
void draw_ellipses(const std::vector<Ellipse>& ellipses, const PlaneMap& map, const Box& box, double width,
                   Canvas& canvas);

}  // namespace boxplus::app
