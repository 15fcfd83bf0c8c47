// SPDX-License-Identifier: BSD-3-Clause
// Holds or frees parts of a problem of bundle adjustment: poses, points, parts of the intrinsics.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "boxplus/graph/graph.h"

namespace boxplus {

/// A part of the unknowns of bundle adjustment.
enum class BundlePart : std::uint8_t {
  kPoses,            ///< SE3 vertices (no parameters), and the pose of each vertex of BAL
  kPoints,           ///< Vector3 vertices (no parameters)
  kFocalLengths,     ///< f, or fx and fy
  kPrincipalPoints,  ///< cx and cy
  kDistortion,       ///< all other parameters of cameras
  kIntrinsics        ///< all parameters of cameras
};
/// "principal-points"
std::string_view to_string(BundlePart part);
/// The part with this name, or none.
std::optional<BundlePart> find_bundle_part(std::string_view name);
std::span<const BundlePart> bundle_parts();

/// Holds a part at its estimates, or frees it, for all runs: vertices are fixed (Graph::fix()), or some of
/// their directions (Graph::fix_directions()). All other directions stay as they are. Knows the cameras of
/// boxplus (types/ba/camera_models.h). Returns the number of vertices that have this part. O(vertices).
std::size_t hold(Graph& graph, BundlePart part, bool held = true);

/// Sets Ω = I / sigma² of all reprojection errors of the cameras of boxplus, where `sigma` is the standard
/// deviation of each coordinate of a pixel. Returns the number of these edges. Throws InvalidArgument unless
/// sigma is in [1e-100, 1e100]. O(edges).
std::size_t set_pixel_sigma(Graph& graph, double sigma);

}  // namespace boxplus
