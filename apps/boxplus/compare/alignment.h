// SPDX-License-Identifier: BSD-3-Clause
// Pairs the poses of a result with the poses of the true trajectory, and finds the motion that aligns the
// result with the truth.
#pragma once

#include <cstdint>
#include <vector>

#include "compare/trajectory.h"

namespace boxplus::app {

/// A pose of the result, and the true pose with the same id or at the same time.
struct PosePair {
  TrajectoryPose result, truth;
};

/// Pairs poses with equal ids. If both trajectories have times instead of ids, pairs a pose of the result
/// with a pose of the truth if each is the nearest in time to the other, and if they are at most
/// `most_seconds` apart. The pairs are in the order of the truth. Takes O(n) time. Throws InvalidArgument if
/// one trajectory has times and the other has ids, or if one lies in the plane and the other in space.
std::vector<PosePair> matched(const Trajectory& result, const Trajectory& truth, double most_seconds);

enum class AlignmentKind : std::uint8_t { kRigid, kFirst, kNone };

/// The map p ↦ scale · rotation · p + translation from the world frame of the result to the world frame of
/// the truth.
struct Alignment {
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 translation = Vector3::Zero();
  double scale = 1;

  TrajectoryPose operator()(TrajectoryPose pose) const;
};

/// kRigid: the motion that minimizes the sum of squared distances (Umeyama, Least-squares estimation of
/// transformation parameters between two point patterns, PAMI 1991), with a scale if `with_scale` is true.
/// kFirst: the motion that maps the first pose of the result to its true pose. kNone: no motion. `pairs` must
/// not be empty. Throws InvalidArgument if `with_scale` is true and no scale above 0 fits, for example
/// because all poses of the result are at one position.
Alignment align(const std::vector<PosePair>& pairs, int dimension, AlignmentKind kind, bool with_scale);

}  // namespace boxplus::app
