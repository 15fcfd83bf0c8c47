// SPDX-License-Identifier: BSD-3-Clause
// Pairs the poses of a result with those of its truth, and finds the motion that aligns them.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/trajectory.h"

namespace boxplus::app {

/// A pose of the result and the true pose at the same moment.
struct PosePair {
  TrajectoryPose result, truth;
};

/// Pairs poses of equal id. If both trajectories have times, pairs poses that are each other's nearest in
/// time and at most `most_seconds` apart. The pairs are in the order of the truth; O(n). Throws
/// InvalidArgument if one has times and the other ids, or if one lies in the plane and the other in space.
std::vector<PosePair> matched(const Trajectory& result, const Trajectory& truth, double most_seconds);

enum class AlignmentKind : std::uint8_t { kRigid, kFirst, kNone };

/// p ↦ scale · rotation · p + translation, from the world of the result to that of the truth.
struct Alignment {
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 translation = Vector3::Zero();
  double scale = 1;

  TrajectoryPose operator()(TrajectoryPose pose) const;
};

/// kRigid: the motion with the least sum of squared distances (Umeyama, Least-squares estimation of
/// transformation parameters between two point patterns, PAMI 1991), with a scale on request. kFirst: the
/// motion that maps the first pose to its truth. `pairs` must not be empty. Throws InvalidArgument if a scale
/// is requested and all poses of the result are at one position.
Alignment align(const std::vector<PosePair>& pairs, int dimension, AlignmentKind kind, bool with_scale);

}  // namespace boxplus::app
