// SPDX-License-Identifier: BSD-3-Clause
#include "compare/trajectory.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "boxplus/base/error.h"
#include "boxplus/io/file_format.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/manifold/quaternion.h"
#include "files/graph_input.h"

namespace boxplus::app {
namespace {

/// Returns true if the text is a TUM file. Lines of TUM files begin with times. Lines of graph files begin
/// with tags, or a format other than .g2o recognizes the text.
bool is_tum(std::string_view text) {
  if (default_formats().recognize(text) != &default_formats().all().front()) return false;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return false;
    if (text[begin] != '#')
      return std::string_view("+-.0123456789").find(text[begin]) != std::string_view::npos;
    text.remove_prefix(std::min(text.find('\n', begin), text.size()));
  }
  return false;
}

TrajectoryPose pose_of(const detail::Frame& frame, Id id) {
  TrajectoryPose pose;
  pose.id = id;
  for (int row = 0; row < frame.dimension; ++row) {
    pose.position[row] = frame.translation[static_cast<std::size_t>(row)];
    for (int column = 0; column < frame.dimension; ++column)
      pose.rotation(row, column) = frame.rotation[static_cast<std::size_t>(row * frame.dimension + column)];
  }
  // Quaternions in files have rounding errors, so the rotation must be normalized.
  pose.rotation = detail::rotation_matrix(detail::normalized(detail::quaternion_of(pose.rotation)));
  return pose;
}

Trajectory poses_of(const Graph& graph, const std::string& name) {
  Trajectory trajectory{.dimension = 0};
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (!graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame) || !frame.has_rotation) continue;
    if (trajectory.dimension != 0 && trajectory.dimension != frame.dimension)
      throw FileError(name + ": expected poses in the plane or poses in space, got both");
    trajectory.dimension = frame.dimension;
    trajectory.poses.push_back(pose_of(frame, graph.id(vertex)));
  }
  return trajectory;
}

/// Throws FileError if a position is so far from the origin that its squared length could overflow.
void require_bounded(const Trajectory& trajectory, const std::string& name) {
  constexpr double kFarthest = 1e100;
  for (const TrajectoryPose& pose : trajectory.poses) {
    if (pose.position.cwiseAbs().maxCoeff() < kFarthest && pose.rotation.allFinite()) continue;
    throw FileError(
        fmt::format("{}: expected poses within {:g} m of the origin; the pose of {} {} is farther away", name,
                    kFarthest, trajectory.is_timed() ? "line" : "vertex", pose.id));
  }
}

/// Adds what a BAL problem or a COLMAP model says about the identity of its poses.
void identify(std::vector<TrajectoryPose>& poses, const GraphFile& file) {
  std::unordered_map<Id, TrajectoryPose*> pose_of;
  for (TrajectoryPose& pose : poses) pose_of[pose.id] = &pose;
  if (file.model) {
    for (std::size_t i = 0; i < file.model->images.size(); ++i) {
      const SparseModel::Image& image = file.model->images[i];
      TrajectoryPose& pose = *pose_of.at(image.id);
      pose.name = image.name;
      pose.position_in_file = i;
    }
  } else {
    for (std::size_t i = 0; i < poses.size(); ++i) poses[i].position_in_file = i;
  }
  for (const EdgeRef& edge : file.edges)
    ++pose_of.at(file.graph.id(file.graph.vertices(edge).front()))->observations;
}

}  // namespace

Trajectory read_trajectory(const std::string& path, const ReadOptions& reading) {
  const std::string text = read_text(path), name = input_name(path);
  if (is_tum(text)) {
    Trajectory trajectory = parse_tum(text, name);
    require_bounded(trajectory, name);
    return trajectory;
  }
  const GraphFile file = parse_input(text, path, reading);
  print_notes(file, path);
  if (file.vertices_created)
    throw FileError(name + ": expected poses, got a file with edges only; optimize it first");
  Trajectory trajectory = trajectory_of(file.graph, name);
  if (file.model || file.format == "BAL") {
    trajectory.source = file.model ? TrajectorySource::kColmap : TrajectorySource::kBal;
    identify(trajectory.poses, file);
  }
  return trajectory;
}

Trajectory trajectory_of(const Graph& graph, const std::string& name) {
  Trajectory trajectory = poses_of(graph, name);
  if (trajectory.poses.empty()) throw FileError(name + ": expected poses, got a graph without poses");
  require_bounded(trajectory, name);
  return trajectory;
}

}  // namespace boxplus::app
