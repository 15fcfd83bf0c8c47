// SPDX-License-Identifier: BSD-3-Clause
// The motion of vertices when a small similarity moves the world: translation, rotation, scale.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <vector>

#include "gauge/edge_ends.h"

namespace boxplus {

/// The way in which a vertex's estimate depends on the coordinates of the world.
enum class WorldRole : std::uint8_t {
  kNone,     ///< no dependence, such as for a focal length or a bias
  kFrame,    ///< T_world_body, or a point in the world
  kInverse,  ///< T_body_world, such as the pose of a camera that maps world points to its own frame
  /// A similarity S_world_body, whose tangent ends with the logarithm of its scale, as that of Sim3. It
  /// scales with the world.
  kSimilarity
};

/// One direction of a vertex without a frame: a focal length, or one component of a bias.
struct OwnDirection {
  VertexSlot vertex;
  int component;
};

/// The small similarities of a world of 2 or 3 dimensions: translations along each axis, then rotations about
/// axes through `center`, then scaling about `center`. Translations are in units of `length`, so that all
/// motions move a vertex at distance `length` about equally far. The last motions are changes of the
/// directions `own`.
struct WorldMotions {
  int dimension = 3;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double length = 1;
  std::vector<OwnDirection> own;

  int translations() const { return dimension; }
  int rotations() const { return dimension == 2 ? 1 : 3; }
  int in_world() const { return translations() + rotations() + 1; }
  int count() const { return in_world() + static_cast<int>(own.size()); }
  /// If a motion of unit size moves a vertex, it moves the vertex by at least about this many meters or
  /// radians.
  double unit() const { return std::min(1.0, length); }
};

/// Gets the frame of a vertex in the world: T_world_body or a point. Returns false if the vertex has no frame
/// of this dimension.
bool world_frame(const Graph& graph, VertexSlot vertex, WorldRole role, int dimension, detail::Frame& out);

/// The derivative of the vertex's tangent with respect to each motion: tangent_dim × count(). Similarities of
/// the world do not change vertices with WorldRole::kNone, or without a frame of this dimension.
Eigen::MatrixXd motion_tangents(const Graph& graph, VertexSlot vertex, WorldRole role,
                                const WorldMotions& motions);

}  // namespace boxplus
