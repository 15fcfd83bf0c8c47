// SPDX-License-Identifier: BSD-3-Clause
// A pose graph as arrays of doubles, which is the input of CeresPeer. This header includes neither boxplus
// nor Eigen, so that code with other compiler flags may include it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace boxplus::bench {

struct PlainGraph {
  /// A measurement z of the pose `to` relative to the pose `from`. `root_information` is S with Ω = SᵀS, row
  /// by row. It has 3 × 3 or 6 × 6 values.
  struct Motion {
    std::size_t from, to;
    std::array<double, 7> z;
    std::array<double, 36> root_information;
  };
  /// A measurement z of a 2D point in the frame of a pose.
  struct Observation {
    std::size_t pose, point;
    std::array<double, 2> z;
    std::array<double, 4> root_information;
  };

  std::size_t pose_size = 3;  ///< the number of scalars per pose: 3 (x y θ) or 7 (x y z qx qy qz qw)
  std::vector<double> poses;
  std::vector<double> points;       ///< x and y of each point
  std::vector<bool> pose_is_fixed;  ///< one value per pose
  std::vector<Motion> motions;
  std::vector<Observation> observations;
};

}  // namespace boxplus::bench
