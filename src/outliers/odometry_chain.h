// SPDX-License-Identifier: BSD-3-Clause
// The poses along the odometry, and the uncertainty of the motion between any two of them.
#pragma once

#include <cstdint>
#include <vector>

#include "outliers/path_sums.h"

namespace boxplus::outliers {

class OdometryChain {
 public:
  /// Chains the best link between each pose and the next one. A gap starts a new part.
  explicit OdometryChain(const PoseGraph& poses);

  /// Poses of the same part are connected by odometry.
  std::uint32_t part(std::uint32_t pose) const { return part_[pose]; }
  std::uint32_t parts() const { return part_.empty() ? 0 : part_.back() + 1; }
  /// T_part_pose: the pose in the frame of the first pose of its part.
  const Motion& pose(std::uint32_t pose) const { return pose_[pose]; }
  /// The sums of the path between two poses of one part, in either order.
  PathSums between(std::uint32_t a, std::uint32_t b) const {
    return a < b ? sums_[b] - sums_[a] : sums_[a] - sums_[b];
  }

 private:
  std::vector<std::uint32_t> part_;
  std::vector<Motion> pose_;
  std::vector<PathSums> sums_;  // from the beginning of the part
};

}  // namespace boxplus::outliers
