// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

#include "boxplus/base/error.h"
#include "io/ply/camera_pyramids.h"
#include "trajectory/trajectory_errors.h"
#include "trajectory/tum.h"

namespace boxplus::viewer {
namespace {

using Place = std::array<double, 3>;

std::unordered_map<Id, Place> points_of(const Graph& graph) {
  std::unordered_map<Id, Place> points;
  for (const VertexRef& vertex : graph.all_vertices()) {
    detail::Frame frame;
    if (graph.vertex_pools()[vertex.pool]->get_frame(vertex.slot, frame) && !frame.has_rotation)
      points[graph.id(vertex)] = frame.translation;
  }
  return points;
}

Place place_of(const TrajectoryPose& pose) {
  return {pose.position[0], pose.position[1], pose.position[2]};
}

Place median_of(const std::vector<Place>& places) {
  Place center{};
  for (std::size_t axis = 0; axis < center.size(); ++axis) {
    std::vector<double> values;
    for (const Place& place : places) {
      if (std::isfinite(place[axis])) values.push_back(place[axis]);
    }
    center[axis] = median(std::move(values));
  }
  return center;
}

/// "poses in the plane"
const char* kind_of(const Trajectory& trajectory) {
  switch (trajectory.dimension) {
    case 2:
      return "poses in the plane";
    case 3:
      return "poses in space";
    default:
      return "no poses";
  }
}

}  // namespace

struct Truth::Poses {
  Trajectory trajectory;
  std::unordered_map<Id, Place> places;  ///< by the ids of the graph; before match(), those of the points
  std::vector<PosePair> pairs = {};      ///< of the matched poses that the graph has
  std::vector<VertexRef> vertices = {};  ///< of `pairs`
  bool turns_result = false;             ///< PosePairs::turns_result
  Place center{};                        ///< the origin of TruthPlaces
};

Truth::Truth(const GraphFile& file, std::string name)
    : poses_(new Poses{trajectory_of(file, name), points_of(file.graph)}) {
  facts_.name = std::move(name);
  facts_.true_poses = poses_->trajectory.poses.size();
}

Truth::~Truth() = default;
Truth::Truth(Truth&&) noexcept = default;
Truth& Truth::operator=(Truth&&) noexcept = default;

void Truth::match(const Graph& graph, const GraphFile* file, const std::string& name) {
  const Trajectory poses = file != nullptr ? trajectory_of(*file, name) : trajectory_of(graph, name);
  if (poses.dimension != poses_->trajectory.dimension) {
    throw FileError(fmt::format("{}: expected a truth for {}, which has {}, but it has {}", facts_.name, name,
                                kind_of(poses), kind_of(poses_->trajectory)));
  }
  PosePairs matched{{}, ""};
  try {
    matched = matched_poses(poses, poses_->trajectory, 0);
  } catch (const InvalidArgument& mismatch) {
    throw FileError(fmt::format("{}: {}", facts_.name, mismatch.what()));
  }
  if (matched.pairs.empty()) {
    throw FileError(fmt::format("{}: expected poses that match {} by {}, found none", facts_.name, name,
                                matched.matched_by));
  }
  // Each COLMAP model numbers its points on its own.
  if (poses.source != poses_->trajectory.source || poses.source == TrajectorySource::kColmap)
    poses_->places.clear();
  for (const PosePair& pair : matched.pairs) poses_->places[pair.result.id] = place_of(pair.truth);
  poses_->pairs = std::move(matched.pairs);
  poses_->turns_result = matched.turns_result;
  facts_.matched_by = matched.matched_by;
  facts_.matched = poses_->pairs.size();
  facts_.poses = poses.poses.size();
}

TruthPlaces Truth::place(const Graph& graph, const Structure& structure) {
  std::erase_if(poses_->pairs, [&](const PosePair& pair) { return !graph.find_vertex(pair.result.id); });
  facts_.matched = poses_->pairs.size();
  poses_->vertices.clear();
  for (const PosePair& pair : poses_->pairs) poses_->vertices.push_back(*graph.find_vertex(pair.result.id));

  constexpr double kFarthest = 1e18;  // products of lengths must fit into a float
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  std::vector<Place> places;
  places.reserve(structure.count);
  for (const VertexGroup& group : structure.vertices) {
    for (const std::uint32_t slot : group.slots) {
      const auto found = poses_->places.find(graph.vertex_pools()[group.pool]->id(slot));
      places.push_back(found != poses_->places.end() ? found->second : Place{kNowhere, kNowhere, kNowhere});
    }
  }
  poses_->center = median_of(places);
  TruthPlaces result;
  result.reserve(3 * places.size());
  for (Place& place : places) {
    bool is_drawn = true;
    for (std::size_t axis = 0; axis < place.size(); ++axis) {
      place[axis] -= poses_->center[axis];
      is_drawn = is_drawn && std::abs(place[axis]) < kFarthest;
    }
    for (const double each : place) result.push_back(static_cast<float>(is_drawn ? each : kNowhere));
  }
  return result;
}

std::optional<TruthFit> Truth::fit(const Graph& graph, const Structure& structure) const {
  for (std::size_t k = 0; k < poses_->pairs.size(); ++k) {
    TrajectoryPose& pose = poses_->pairs[k].result;
    detail::Frame frame;
    graph.vertex_pools()[poses_->vertices[k].pool]->get_frame(poses_->vertices[k].slot, frame);
    set_pose(pose, frame);
    if (!is_bounded(pose)) return std::nullopt;
    if (poses_->turns_result) turn_to_colmap_axes(pose);
  }
  if (poses_->pairs.empty()) return std::nullopt;
  const Alignment onto_truth =
      align_poses(poses_->pairs, poses_->trajectory.dimension, AlignmentKind::kRigid, /*with_scale=*/false);
  const RelativeError relative = relative_error(poses_->pairs, onto_truth.scale, {});
  TruthFit fit{.ate = absolute_error(poses_->pairs, onto_truth).rmse,
               .rpe_translation = relative.translation.rmse,
               .rpe_rotation = relative.rotation.rmse,
               .motions = relative.translation.count};
  const Alignment onto_graph = onto_truth.inverse();
  const Vector3 origin = onto_graph.rotation * Vector3(poses_->center.data()) + onto_graph.translation -
                         Vector3(structure.center.data());
  Vector3::Map(fit.translation.data()) = origin;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(fit.rotation.data()) = onto_graph.rotation;
  return fit;
}

Truth parse_truth(const std::string& name, const std::string& text) {
  refuse_tum(text, name);
  return Truth(parse_graph(text, name), name);
}

}  // namespace boxplus::viewer
