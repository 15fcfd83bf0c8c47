// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory/trajectory.h"

#include <fmt/format.h>

#include <unordered_map>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/quaternion.h"

namespace boxplus {
namespace {

constexpr double kFarthest = 1e100;

Trajectory poses_of(const Graph& graph, const std::string& name) {
  Trajectory trajectory{.dimension = 0};
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame) || !frame.has_rotation) continue;
    if (trajectory.dimension != 0 && trajectory.dimension != frame.dimension)
      throw FileError(name + ": expected poses in the plane or poses in space, got both");
    trajectory.dimension = frame.dimension;
    TrajectoryPose pose{.id = graph.id(vertex)};
    set_pose(pose, frame);
    trajectory.poses.push_back(std::move(pose));
  }
  return trajectory;
}

/// Adds what a BAL problem or a COLMAP model says about the identity of its poses. Vertices and edges that
/// were removed from the graph do not count.
void identify(std::vector<TrajectoryPose>& poses, const GraphFile& file) {
  std::unordered_map<Id, TrajectoryPose*> pose_of;
  for (TrajectoryPose& pose : poses) pose_of[pose.id] = &pose;
  if (file.model) {
    for (std::size_t i = 0; i < file.model->images.size(); ++i) {
      const SparseModel::Image& image = file.model->images[i];
      const auto pose = pose_of.find(image.id);
      if (pose == pose_of.end()) continue;
      pose->second->name = image.name;
      pose->second->position_in_file = i;
    }
  } else {
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].position_in_file = i;
  }
  for (const EdgeRef& edge : file.edges) {
    if (file.graph.contains(edge))
      ++pose_of.at(file.graph.id(file.graph.vertices(edge).front()))->observations;
  }
}

}  // namespace

Trajectory trajectory_of(const Graph& graph, const std::string& name) {
  Trajectory trajectory = poses_of(graph, name);
  if (trajectory.poses.empty()) throw FileError(name + ": expected poses, got a graph without poses");
  require_bounded(trajectory, name);
  return trajectory;
}

Trajectory trajectory_of(const GraphFile& file, const std::string& name) {
  if (file.vertices_created)
    throw FileError(name + ": expected poses, got a file with edges only; optimize it first");
  Trajectory trajectory = trajectory_of(file.graph, name);
  if (file.model || file.format == "BAL") {
    trajectory.source = file.model ? TrajectorySource::kColmap : TrajectorySource::kBal;
    identify(trajectory.poses, file);
  }
  return trajectory;
}

void set_pose(TrajectoryPose& pose, const detail::Frame& frame) {
  for (int row = 0; row < frame.dimension; ++row) {
    pose.position[row] = frame.translation[row];
    for (int column = 0; column < frame.dimension; ++column)
      pose.rotation(row, column) = frame.rotation[row * frame.dimension + column];
  }
  // Quaternions in files have rounding errors, so the rotation must be normalized.
  pose.rotation = detail::rotation_matrix(detail::normalized(detail::quaternion_of(pose.rotation)));
}

bool is_bounded(const TrajectoryPose& pose) {
  return pose.position.cwiseAbs().maxCoeff() < kFarthest && pose.rotation.allFinite();
}

void require_bounded(const Trajectory& trajectory, const std::string& name) {
  for (const TrajectoryPose& pose : trajectory.poses) {
    if (is_bounded(pose)) continue;
    throw FileError(
        fmt::format("{}: expected poses within {:g} m of the origin; the pose of {} {} is farther away", name,
                    kFarthest, trajectory.is_timed() ? "line" : "vertex", pose.id));
  }
}

}  // namespace boxplus
