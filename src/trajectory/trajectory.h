// SPDX-License-Identifier: BSD-3-Clause
// The poses of a trajectory, from a graph or a TUM file.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/base/matrix.h"
#include "boxplus/graph/frame.h"
#include "boxplus/graph/handle.h"
#include "boxplus/io/graph_file.h"

namespace boxplus {

/// A pose T_world_body. In the plane, z is 0 and the rotation is about z.
struct TrajectoryPose {
  double time = 0;        ///< the time in seconds; 0 if the pose is from a graph
  Id id = 0;              ///< the id of the vertex; if the pose is from a TUM file, the line number
  std::string name = {};  ///< of a COLMAP image
  /// Of a COLMAP image or a BAL camera: its position in the file (from 0), and the number of 3-D points that
  /// it shows.
  std::size_t position_in_file = 0, observations = 0;
  Matrix<double, 3, 3> rotation = Matrix<double, 3, 3>::Identity();
  Vector3 position = Vector3::Zero();  ///< the position in meters
};

/// The kind of a file, which decides what identifies a pose: an id in graphs, the position in the file in BAL
/// problems, a name in COLMAP models, and a time in TUM files.
enum class TrajectorySource : std::uint8_t { kGraph, kBal, kColmap, kTum };

struct Trajectory {
  TrajectorySource source = TrajectorySource::kGraph;
  int dimension = 3;                       ///< the dimension of the world: 2 or 3
  std::vector<TrajectoryPose> poses = {};  ///< sorted by time or by id; no two have equal times or ids

  bool is_timed() const { return source == TrajectorySource::kTum; }
};

/// Returns the poses of a graph, without its landmarks. Messages call the graph `name`. Throws FileError if
/// the graph has no poses, if it has poses both in the plane and in space, or if a pose is more than 1e100 m
/// away from the origin.
Trajectory trajectory_of(const Graph& graph, const std::string& name);
/// Does the same for the graph of a file, and adds what identifies its poses. Also throws FileError if the
/// file has no estimates.
Trajectory trajectory_of(const GraphFile& file, const std::string& name);

/// Sets the position and the rotation of a pose to those of a vertex.
void set_pose(TrajectoryPose& pose, const detail::Frame& frame);
/// True if the position is less than 1e100 m away from the origin in each direction, so that its squared
/// length does not overflow, and the rotation is finite.
bool is_bounded(const TrajectoryPose& pose);
/// Throws FileError if a pose is not bounded.
void require_bounded(const Trajectory& trajectory, const std::string& name);

}  // namespace boxplus
