// SPDX-License-Identifier: BSD-3-Clause
// Tests pairs of closures between neighboring poses: the cycle through both closures must close.
#pragma once

#include <vector>

#include "outliers/evidence.h"
#include "outliers/odometry_chain.h"

namespace boxplus::outliers {

struct CycleTests {
  std::vector<double> support;  ///< for each closure: the most evidence of all its pairs; −∞ without pairs
  /// For each closure, one closure of its group, the same one for all of a group. The closures of a group
  /// support each other, directly or through others. A closure without support is a group of its own.
  std::vector<std::uint32_t> group;
  std::vector<std::uint32_t> supporters;  ///< for each closure, the number of closures that support it
  std::vector<std::uint32_t> group_size;  ///< for each closure, the number of closures in its group
  double noise_scale = 1;                 ///< the scale of the noise that explains the cycles
};

/// Tests each closure with its nearest neighbors. Two closures support each other if their log odds are at
/// least `needed`. O(n w) for n closures, where w is the number of closures in
/// the window of a closure.
CycleTests test_cycles(const PoseGraph& poses, const OdometryChain& chain, const Evidence& evidence,
                       double needed, int window);

}  // namespace boxplus::outliers
