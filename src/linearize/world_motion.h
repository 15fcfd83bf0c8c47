// SPDX-License-Identifier: BSD-3-Clause
// How vertices move when the world is moved by a small similarity: translation, rotation, scale.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "boxplus/graph/vertex_pool.h"

namespace boxplus {

/// How the estimate of a vertex depends on the world's coordinates.
enum class WorldRole : std::uint8_t {
  kNone,    ///< not at all: a focal length, a bias
  kFrame,   ///< as T_world_body, or as a point of the world
  kInverse  ///< as T_body_world, e.g. the pose of a camera that maps world points into its own frame
};

/// The small similarities of a world of 2 or 3 dimensions: translations along each axis, then rotations about
/// axes through `center`, then scaling about `center`. Translations are measured in units of `length`, so
/// that all of them move a vertex at distance `length` about equally far.
struct WorldMotions {
  static constexpr int kMost = 7;

  int dimension = 3;
  std::array<double, 3> center{};
  double length = 1;

  int translations() const { return dimension; }
  int rotations() const { return dimension == 2 ? 1 : 3; }
  /// The least that a motion of unit size moves a tangent by, if it moves it: meters or radians.
  double unit() const { return std::min(1.0, length); }
  int count() const { return translations() + rotations() + 1; }
};

/// The vertex as it stands in the world: T_world_body or a point. False if it has no frame of that dimension.
bool world_frame(const VertexPool& pool, std::uint32_t slot, WorldRole role, int dimension, Frame& out);

/// Writes the derivative of the vertex' tangent with respect to each motion: tangent_dim × count(),
/// column-major. Zero for WorldRole::kNone and for vertices without a frame of that dimension.
void motion_tangents(const VertexPool& pool, std::uint32_t slot, WorldRole role, const WorldMotions& motions,
                     double* out);

}  // namespace boxplus
