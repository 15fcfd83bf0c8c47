// SPDX-License-Identifier: BSD-3-Clause
// The motion of vertices when a small similarity moves the world: translation, rotation, scale.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "boxplus/graph/vertex_pool.h"

namespace boxplus {

/// The way in which a vertex's estimate depends on the coordinates of the world.
enum class WorldRole : std::uint8_t {
  kNone,    ///< no dependence, such as for a focal length or a bias
  kFrame,   ///< T_world_body, or a point in the world
  kInverse  ///< T_body_world, such as the pose of a camera that maps world points to its own frame
};

/// The small similarities of a world of 2 or 3 dimensions: translations along each axis, then rotations about
/// axes through `center`, then scaling about `center`. Translations are in units of `length`, so that all
/// motions move a vertex at distance `length` about equally far.
struct WorldMotions {
  static constexpr int kMost = 7;

  int dimension = 3;
  std::array<double, 3> center{};
  double length = 1;

  int translations() const { return dimension; }
  int rotations() const { return dimension == 2 ? 1 : 3; }
  /// If a motion of unit size moves a vertex, it moves the vertex by at least about this many meters or
  /// radians.
  double unit() const { return std::min(1.0, length); }
  int count() const { return translations() + rotations() + 1; }
};

/// Gets the frame of a vertex in the world: T_world_body or a point. Returns false if the vertex has no frame
/// of this dimension.
bool world_frame(const detail::VertexPool& pool, std::uint32_t slot, WorldRole role, int dimension,
                 detail::Frame& out);

/// Writes the derivative of the vertex's tangent with respect to each motion: tangent_dim × count(),
/// column-major. Writes zeros for WorldRole::kNone and for vertices without a frame of this dimension.
void motion_tangents(const detail::VertexPool& pool, std::uint32_t slot, WorldRole role,
                     const WorldMotions& motions, double* out);

}  // namespace boxplus
