// SPDX-License-Identifier: BSD-3-Clause
// The poses of a path, as `boxplus compare` reads them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/handle.h"
#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// A pose T_world_body. In the plane, z is 0 and the rotation is about z.
struct TrajectoryPose {
  double time = 0;  ///< seconds; 0 in a graph
  Id id = 0;        ///< of the vertex; in a TUM file, the number of the line
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 position = Vector3::Zero();  ///< meters
};

struct Trajectory {
  bool is_timed = false;                   ///< true for a TUM file: its poses have times instead of ids
  int dimension = 3;                       ///< 2 or 3
  std::vector<TrajectoryPose> poses = {};  ///< sorted by time, or by id; no two are equal
};

/// Reads the poses of a graph (without its landmarks), or of a TUM file: "time x y z qx qy qz qw" per line. A
/// file is a TUM file if its first line that is neither blank nor a comment begins with a number. Throws
/// FileError, and InputError with the position of the error.
Trajectory read_trajectory(const std::string& path, const ReadOptions& reading);

/// The poses of a graph; messages call it `name`. Throws FileError if it has no poses, if it has poses in the
/// plane and in space, or if a pose is farther than 1e100 m away.
Trajectory trajectory_of(const Graph& graph, const std::string& name);

/// Parses a TUM file; messages call it `name`.
Trajectory parse_tum(std::string_view text, const std::string& name);

}  // namespace boxplus::app
