// SPDX-License-Identifier: BSD-3-Clause
// A pose graph as arrays of doubles, the input of the peers. Includes neither boxplus nor Eigen, so that code
// with other compiler flags may include it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxplus::bench {

struct PlainGraph {
  /// z measures pose `to` from pose `from`. S, with Ω = SᵀS, row by row: 3 × 3 or 6 × 6 values.
  struct Motion {
    std::size_t from, to;
    std::array<double, 7> z;
    std::array<double, 36> root_information;
  };
  /// z measures a point in the plane from a pose.
  struct Observation {
    std::size_t pose, point;
    std::array<double, 2> z;
    std::array<double, 4> root_information;
  };

  std::size_t pose_size = 3;  ///< scalars per pose: x y θ, or 7: x y z qx qy qz qw
  std::vector<double> poses;
  std::vector<double> points;       ///< x y
  std::vector<bool> pose_is_fixed;  ///< per pose
  std::vector<Motion> motions;
  std::vector<Observation> observations;
};

}  // namespace boxplus::bench
