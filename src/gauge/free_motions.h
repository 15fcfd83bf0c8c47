// SPDX-License-Identifier: BSD-3-Clause
// The translations, rotations and scalings of a component that change none of its errors.
#pragma once

#include <array>
#include <vector>

#include "gauge/similarity_freedom.h"

namespace boxplus {

/// Free motions in a world of 2 or 3 dimensions. A rotation is about an axis through any point. If a space of
/// directions contains as many coordinate axes as it has dimensions, it is listed by these axes.
struct FreeMotions {
  using Axis = std::array<double, 3>;  ///< a unit vector
  int dimension = 0;                   ///< of the world: 2 or 3
  std::vector<Axis> along = {};        ///< the free translations; orthogonal
  std::vector<Axis> about = {};        ///< the axes of the free rotations; orthogonal, (0, 0, 1) in the plane
  bool scale = false;
  int count = 0;  ///< the number of independent motions
};

/// All rigid motions of a world of this dimension.
FreeMotions all_rigid_motions(int dimension);
FreeMotions free_motions_of(const SimilarityFreedom& freedom);

}  // namespace boxplus
