// SPDX-License-Identifier: BSD-3-Clause
// What cameras see: the points of a graph in the frames of the cameras.
#pragma once

#include <vector>

#include "diagnose/evidence.h"

namespace boxplus {

/// The share of edges whose points are on the side of their cameras on which most points are.
double one_sided_share(const CameraViews& views);

/// Finds the pools whose edges are images of points: errors with two rows between a pose and a point in
/// space, which do not change if the point moves along the ray from the camera. The pose is T_world_camera or
/// T_camera_world. Ignores pools with fewer than ten finite edges. O(edges).
std::vector<CameraViews> find_camera_views(const Evidence& evidence);

}  // namespace boxplus
