// SPDX-License-Identifier: BSD-3-Clause
// Finds the motion that aligns a result with the true trajectory.
#pragma once

#include <cstdint>
#include <vector>

#include "trajectory/matching.h"

namespace boxplus {

enum class AlignmentKind : std::uint8_t { kRigid, kFirst, kNone };

/// The map p ↦ scale · rotation · p + translation from the world frame of the result to the world frame of
/// the truth.
struct Alignment {
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 translation = Vector3::Zero();
  double scale = 1;

  TrajectoryPose operator()(TrajectoryPose pose) const;
  /// The map from the world frame of the truth to that of the result.
  Alignment inverse() const;
};

/// kRigid: the motion that minimizes the sum of squared distances (Umeyama, Least-squares estimation of
/// transformation parameters between two point patterns, PAMI 1991), with a scale if `with_scale` is true.
/// kFirst: the motion that maps the first pose of the result to its true pose. kNone: no motion. `pairs` must
/// not be empty. Throws InvalidArgument if `with_scale` is true and no scale above 0 fits, for example
/// because all poses of the result are at one position.
Alignment align_poses(const std::vector<PosePair>& pairs, int dimension, AlignmentKind kind, bool with_scale);

}  // namespace boxplus
