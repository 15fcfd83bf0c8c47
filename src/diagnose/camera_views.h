// SPDX-License-Identifier: BSD-3-Clause
// What cameras see: the points of a graph in the frames of the cameras.
#pragma once

#include <cstdint>
#include <vector>

namespace boxplus {

class Evidence;

/// The images of one edge pool. The vectors `seen`, `in_front` and `nearest` have an entry for each slot of
/// the pool of points.
struct CameraViews {
  std::uint32_t point_pool = 0;
  std::vector<std::uint32_t> seen, in_front;  ///< the number of edges; of those whose point has a positive z
  std::vector<double> nearest;                ///< the distance of the point from the nearest of its cameras
  std::size_t edges = 0, edges_in_front = 0;
  std::size_t edges_far_off =
      0;  ///< whose image is more than a hundred standard deviations from the measured one
  /// The largest share of points on the same side of their cameras if the poses are read in another way: with
  /// w at the other end of the quaternions, or as the inverse. Computed only if most edges are far off.
  double one_sided_if_swapped = 0, one_sided_if_inverse = 0;
  std::size_t points = 0;      ///< that are seen
  double median_distance = 0;  ///< of the points from their cameras, over all edges
};

/// The share of edges whose points are on the side of their cameras on which most points are.
double one_sided_share(const CameraViews& views);

/// Finds the pools whose edges are images of points: errors with two rows between a pose and a point in
/// space, which do not change if the point moves along the ray from the camera. The pose is T_world_camera or
/// T_camera_world. Ignores pools with fewer than ten finite edges. O(edges).
std::vector<CameraViews> find_camera_views(const Evidence& evidence);

}  // namespace boxplus
