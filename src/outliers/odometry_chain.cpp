// SPDX-License-Identifier: BSD-3-Clause
#include "outliers/odometry_chain.h"

namespace boxplus::outliers {

OdometryChain::OdometryChain(const PoseGraph& poses)
    : part_(poses.poses.size()), pose_(poses.poses.size()), sums_(poses.poses.size()) {
  std::vector<const PoseEdge*> best(poses.poses.size(), nullptr);  // of the links to each pose
  for (const PoseEdge& link : poses.links) {
    const PoseEdge*& known = best[link.to];
    if (known == nullptr || link.spread.translation < known->spread.translation) known = &link;
  }
  for (std::size_t k = 1; k < pose_.size(); ++k) {
    part_[k] = part_[k - 1] + (best[k] == nullptr ? 1 : 0);
    if (best[k] == nullptr) continue;
    pose_[k] = pose_[k - 1] * best[k]->motion;
    sums_[k] = sums_[k - 1];
    sums_[k].add(best[k]->spread, pose_[k].translation);
  }
}

}  // namespace boxplus::outliers
