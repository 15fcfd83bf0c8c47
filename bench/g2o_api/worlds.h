// SPDX-License-Identifier: BSD-3-Clause
// The optimization problems of a visual SLAM system, as a client of the g2o API builds them.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "g2o/core/sparse_optimizer.h"
#include "g2o/types/sba/types_six_dof_expmap.h"
#include "g2o/types/sim3/types_seven_dof_expmap.h"

namespace bench {

/// Keyframes on a circle that look at points around its center, and the points that each keyframe sees. The
/// edges have Huber kernels, and some of them are outliers.
struct BundleSize {
  int keyframes = 120, points = 11'500, fixed = 1;
  int views_per_point = 6;  ///< the keyframes that see a point are consecutive
};
std::unique_ptr<g2o::SparseOptimizer> make_bundle(const BundleSize& size);

/// One pose that sees known points, a tenth of which are outliers.
struct PoseOnly {
  std::unique_ptr<g2o::SparseOptimizer> optimizer;
  g2o::VertexSE3Expmap* pose = nullptr;
  std::vector<g2o::EdgeSE3ProjectXYZOnlyPose*> edges;
  g2o::SE3Quat start;
};
PoseOnly make_pose_only(int points);
/// Four rounds of ten iterations from the first estimate. After each round, outliers go to level 1. The last
/// two rounds have no kernel for inliers. Returns the number of iterations.
int optimize_pose(PoseOnly& world);

/// One similarity between two keyframes that see the same points, all of which are fixed.
std::unique_ptr<g2o::SparseOptimizer> make_similarity(int points);

}  // namespace bench
