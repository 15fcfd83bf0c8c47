// SPDX-License-Identifier: BSD-3-Clause
// Poses along a path, as `boxplus compare` reads them.
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
  double time = 0;  ///< seconds; of a graph: 0
  Id id = 0;        ///< of the vertex; of a TUM file: the number of its line
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 position = Vector3::Zero();  ///< metres
};

struct Trajectory {
  bool is_timed = false;                   ///< a TUM file: poses have times; else they have ids
  int dimension = 3;                       ///< 2 or 3
  std::vector<TrajectoryPose> poses = {};  ///< sorted by time, or by id; no two are equal
};

/// Reads the poses of a graph (landmarks do not count), or a TUM file: "time x y z qx qy qz qw" per line. A
/// file is of the TUM form if its first line that is neither blank nor a comment begins with a number. Throws
/// FileError, and InputError with the place of what is wrong.
Trajectory read_trajectory(const std::string& path, const ReadOptions& reading);

/// The poses of a graph; `name` stands for it in messages. Throws FileError if it has none, or some in the
/// plane and some in space, or one farther than 1e100 m away.
Trajectory trajectory_of(const Graph& graph, const std::string& name);

/// A TUM file from its text; `name` stands for the file in messages.
Trajectory parse_tum(std::string_view text, const std::string& name);

}  // namespace boxplus::app
