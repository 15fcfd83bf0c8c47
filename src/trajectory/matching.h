// SPDX-License-Identifier: BSD-3-Clause
// Pairs the poses of a result with the poses of the true trajectory.
#pragma once

#include <string>
#include <vector>

#include "trajectory/trajectory.h"

namespace boxplus {

/// A pose of the result, and the true pose of the same body.
struct PosePair {
  TrajectoryPose result, truth;
};

struct PosePairs {
  std::vector<PosePair> pairs;  ///< in the order of the truth
  const char* matched_by;       ///< what the poses of a pair share: "id", "name", "position" or "time"
  /// True if the poses of the result are those of BAL's cameras, with the axes of COLMAP's cameras.
  bool turns_result = false;
};

/// Gives a camera of BAL, which looks along −z, the axes of COLMAP's cameras: z forward and y down.
void turn_to_colmap_axes(TrajectoryPose& camera);

/// Pairs poses by what identifies them in both files. Throws InvalidArgument if the files share no such
/// thing, or if one trajectory lies in the plane and the other in space. Takes O(n) time.
///
/// - Two TUM files: by time. A pose of the result and a pose of the truth are a pair if each is the nearest
///   in time to the other, and if they are at most `most_seconds` apart.
/// - Two COLMAP models: by the names of the images, because each model numbers its images on its own. Throws
///   if a name occurs twice.
/// - Two BAL problems: by position, if they have equally many cameras.
/// - A BAL problem and a COLMAP model: by name if the names of the images are the numbers of the cameras, as
///   in a model that boxplus has made from a BAL problem. Otherwise by position in the file, if each camera
///   shows as many points as its image. The poses of the BAL problem get the axes of COLMAP's cameras.
/// - All other graphs: by id.
PosePairs matched_poses(const Trajectory& result, const Trajectory& truth, double most_seconds);

}  // namespace boxplus
