// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/model_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "io/model/camera_types.h"
#include "io/model/pose_places.h"

namespace boxplus {
namespace {

/// The smallest power of ten that is larger than all ids.
template <class Elements>
Id power_above_ids(const Elements& elements) {
  std::uint32_t largest = 0;
  for (const auto& element : elements) largest = std::max(largest, element.id);
  Id power = 10;
  while (power <= static_cast<Id>(largest)) power *= 10;
  return power;
}

/// Adds the edges of all images.
class GraphMaker {
 public:
  explicit GraphMaker(const SparseModel& model) : model_(model) {}

  GraphFile make() {
    Graph& graph = file_.graph;
    for (const SparseModel::Camera& camera : model_.cameras) {
      const CameraType* type = find_camera_type(camera.model);
      cameras_[camera.id] = {type, type->add(graph, camera.id, camera.parameters.data())};
    }
    const std::vector<PosePlace> places = pose_places(model_);
    for (const PosePlace& place : places) add(place);
    const Id first = model_.first_point_vertex();
    for (const SparseModel::Point& point : model_.points) {
      const auto vertex = graph.add_vertex(Vector3(point.position.data()), first + static_cast<Id>(point.id));
      graph.set_eliminated(vertex, true);
      points_[point.id] = vertex;
    }
    count_edges(places);
    for (std::size_t i = 0; i < places.size(); ++i) add_edges(model_.images[i], places[i]);
    return std::move(file_);
  }

 private:
  struct CameraVertex {
    const CameraType* type = nullptr;
    VertexRef vertex;
  };

  void add(const PosePlace& place) {
    Graph& graph = file_.graph;
    if (!poses_.contains(place.vertex))
      poses_[place.vertex] = graph.add_vertex(place.T_world_rig, place.vertex);
    if (place.offset && !offsets_.contains(*place.offset))
      offsets_[*place.offset] = graph.add_parameter(place.T_rig_camera, *place.offset);
  }

  static bool is_tracked(const SparseModel::Feature& feature) {
    return feature.point != SparseModel::Feature::kNoPoint;
  }

  void count_edges(const std::vector<PosePlace>& places) {
    std::size_t all = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const SparseModel::Image& image = model_.images[i];
      const auto edges = std::count_if(image.features.begin(), image.features.end(), is_tracked);
      edge_count_[{cameras_.at(image.camera).type, places[i].offset.has_value()}] +=
          static_cast<std::size_t>(edges);
      all += static_cast<std::size_t>(edges);
    }
    file_.edges.reserve(all);
  }

  void add_edges(const SparseModel::Image& image, const PosePlace& place) {
    const CameraVertex& camera = cameras_.at(image.camera);
    const VertexHandle<SE3> pose = poses_.at(place.vertex);
    std::size_t& expected = edge_count_[{camera.type, place.offset.has_value()}];
    for (const SparseModel::Feature& feature : image.features) {
      if (!is_tracked(feature)) continue;
      const Vector2 pixel(feature.pixel.data());
      const VertexHandle<Vector3> point = points_.at(feature.point);
      file_.edges.push_back(place.offset
                                ? camera.type->observe_on_rig(file_.graph, pixel, pose, point,
                                                              offsets_.at(*place.offset), camera.vertex)
                                : camera.type->observe(file_.graph, pixel, pose, point, camera.vertex));
      if (expected > 0) file_.graph.reserve_edges(file_.edges.back(), std::exchange(expected, 0));
    }
  }

  const SparseModel& model_;
  GraphFile file_;
  std::unordered_map<std::uint32_t, CameraVertex> cameras_;
  std::unordered_map<Id, VertexHandle<SE3>> poses_, offsets_;
  std::unordered_map<std::uint64_t, VertexHandle<Vector3>> points_;
  /// The number of edges of each camera type, of cameras alone and on rigs; 0 when memory is reserved.
  std::map<std::pair<const CameraType*, bool>, std::size_t> edge_count_;
};

/// Counts unusual parts.
class ModelCensus {
 public:
  explicit ModelCensus(const SparseModel& model) : model_(model) {}

  ModelNotes notes() {
    for (const SparseModel::Image& image : model_.images) count(image);
    for (const SparseModel::Point& point : model_.points) count(point);
    note(model_.cameras.size() - used_cameras_.size(), "camera has no image", "cameras have no images");
    note(empty_images_, "image has no observations", "images have no observations");
    note(model_.points.size() - seen_points_.size(), "point has no observations",
         "points have no observations");
    note(duplicates_, "observation is a duplicate: its image shows the same point at another place, too",
         "observations are duplicates: their images show the same points at other places, too");
    note(observations_ - tracked_, "observation of an image is in no track",
         "observations of images are in no track");
    note(untrue_, "entry of a track is ignored, because its image shows no point or another one there",
         "entries of tracks are ignored, because their images show no point or another one there");
    return std::move(notes_);
  }

 private:
  void count(const SparseModel::Image& image) {
    used_cameras_.insert(image.camera);
    images_[image.id] = &image;
    std::vector<std::uint64_t> points;
    for (const SparseModel::Feature& feature : image.features) {
      if (feature.point != SparseModel::Feature::kNoPoint) points.push_back(feature.point);
    }
    observations_ += points.size();
    empty_images_ += static_cast<std::size_t>(points.empty());
    std::sort(points.begin(), points.end());
    const auto end = std::unique(points.begin(), points.end());
    duplicates_ += static_cast<std::size_t>(points.end() - end);
    seen_points_.insert(points.begin(), end);
  }

  void count(const SparseModel::Point& point) {
    const auto before = [](const SparseModel::Observation& a, const SparseModel::Observation& b) {
      return std::pair(a.image, a.feature) < std::pair(b.image, b.feature);
    };
    std::vector<SparseModel::Observation> track = point.track;
    std::sort(track.begin(), track.end(), before);
    const auto end = std::unique(track.begin(), track.end());
    untrue_ += static_cast<std::size_t>(track.end() - end);
    for (auto observation = track.begin(); observation != end; ++observation) {
      const bool is_true = images_.at(observation->image)->features[observation->feature].point == point.id;
      ++(is_true ? tracked_ : untrue_);
    }
  }

  void note(std::size_t count, const char* one, const char* many) {
    if (count > 0) notes_.push_back(fmt::format("{} {}", count, count == 1 ? one : many));
  }

  const SparseModel& model_;
  std::unordered_set<std::uint32_t> used_cameras_;
  std::unordered_set<std::uint64_t> seen_points_;
  std::unordered_map<std::uint32_t, const SparseModel::Image*> images_;
  std::size_t observations_ = 0, empty_images_ = 0, duplicates_ = 0, tracked_ = 0, untrue_ = 0;
  ModelNotes notes_;
};

}  // namespace

Id SparseModel::first_point_vertex() const {
  return power_above_ids(images);
}

Id SparseModel::first_sensor_parameter() const {
  return power_above_ids(cameras);
}

ModelNotes unusual_parts(const SparseModel& model) {
  return ModelCensus(model).notes();
}

GraphFile graph_of(SparseModel model) {
  GraphFile file = GraphMaker(model).make();
  file.model = std::make_shared<const SparseModel>(std::move(model));
  return file;
}

Vector2 error_of(const SparseModel::Camera& camera, const SE3& T_world_camera,
                 const SparseModel::Feature& feature, const Vector3& point) {
  return find_camera_type(camera.model)
             ->project(camera.parameters.data(), T_world_camera.inverse_times(point)) -
         Vector2(feature.pixel.data());
}

}  // namespace boxplus
