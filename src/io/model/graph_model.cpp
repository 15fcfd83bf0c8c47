// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/graph_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>

#include "boxplus/io/graph_file.h"
#include "io/edges_to_write.h"
#include "io/model/axes.h"
#include "io/model/graph_roles.h"
#include "io/model/image_sizes.h"
#include "io/model/model_frames.h"
#include "io/model/model_graph.h"
#include "io/model/pose_places.h"
#include "io/moderate_pose.h"
#include "io/reprojection_losses.h"
#include "io/written_errors.h"

namespace boxplus {
namespace {

using Camera = SparseModel::Camera;
using Feature = SparseModel::Feature;
using Image = SparseModel::Image;
using Observation = SparseModel::Observation;
using Point = SparseModel::Point;
using Role = GraphRoles::Role;

constexpr std::size_t kNone = ~std::size_t{0};

void set_pose(Image& image, const SE3& T_world_camera) {
  const SparseModel::Pose pose = pose_in_file(T_world_camera);
  image.rotation = pose.rotation;
  image.translation = pose.translation;
}

class ModelMaker {
 public:
  explicit ModelMaker(const GraphFileView& file)
      : graph_(file.graph), roles_(file.graph), edges_(edges_to_write(file)) {
    static const SparseModel no_model;
    old_ = file.model ? file.model : &no_model;
    for (const auto& pool : graph_.vertex_pools()) entries_.emplace_back(pool->slots());
    for (const EdgeRef& edge : edges_) {
      pixels_.push_back(edge == EdgeRef{} ? std::nullopt : roles_.observation(edge));
      if (!pixels_.back()) continue;
      for (const VertexRef& vertex : {pixels_.back()->image, pixels_.back()->point})
        entry(vertex).is_observed = true;
    }
    is_taken_.resize(edges_.size());
  }

  SparseModel make() {
    add_old_elements();
    old_cameras_ = model_.cameras.size();
    old_images_ = model_.images.size();
    add_new_elements();
    take_old_edges();
    take_old_tracks();
    take_new_edges();
    set_cameras();
    if (old_->has_frames) add_frames(model_, *old_, roles_);
    check_errors();
    set_errors();
    return std::move(model_);
  }

 private:
  /// A vertex in the model. A BAL image is an image and a camera.
  struct Entry {
    std::size_t index = kNone;   // among the cameras, images or points of the model
    std::size_t camera = kNone;  // of an image, if it has edges: index among the cameras
    bool is_observed = false;    // of an image or a point
    bool is_changed = true;      // since it was read
    bool is_frame = false;       // the vertex of a frame, which may have other images than this one
  };
  Entry& entry(VertexRef vertex) { return entries_[vertex.pool][vertex.slot]; }

  Entry& image_entry(const PixelObservation& seen) {
    if (!seen.offset) {
      if (entry(seen.image).index == kNone)
        refuse_for_colmap(fmt::format("an edge of pose {}, which is that of a rig without a camera there",
                                      graph_.id(seen.image)));
      return entry(seen.image);
    }
    const auto found = images_with_offset_.find({seen.image, *seen.offset});
    if (found == images_with_offset_.end())
      refuse_for_colmap(fmt::format("an edge of pose {} and offset {}, which are those of no image",
                                    graph_.id(seen.image), graph_.id(*seen.offset)));
    return found->second;
  }

  bool has_role(const std::optional<VertexRef>& vertex, Role role) const {
    return vertex && roles_.role(*vertex) == role;
  }

  // ---- Vertices ----

  void add_old_elements() {
    for (const Camera& camera : old_->cameras) {
      next_camera_ = std::max(next_camera_, camera.id + 1);
      const auto vertex = graph_.find_parameter(camera.id);
      if (has_role(vertex, Role::kCamera)) add(camera, *vertex);
    }
    const std::vector<PosePlace> places = pose_places(*old_);
    for (std::size_t i = 0; i < places.size(); ++i) {
      next_image_ = std::max(next_image_, old_->images[i].id + 1);
      add(old_->images[i], places[i]);
    }
    const Id first = old_->first_point_vertex();
    for (const Point& point : old_->points) {
      next_point_ = std::max(next_point_, point.id + 1);
      const auto vertex = graph_.find_vertex(first + static_cast<Id>(point.id));
      if (has_role(vertex, Role::kPoint)) add(point, *vertex);
    }
  }

  void add_new_elements() {
    for (const auto& vertices : {graph_.all_parameters(), graph_.all_vertices()}) {
      for (const VertexRef& vertex : vertices) {
        if (is_left_out(vertex)) continue;
        roles_.require_role(vertex);
        if (entry(vertex).index == kNone && !entry(vertex).is_frame) add_new(vertex);
      }
    }
  }
  /// A constant of edges that are no reprojection errors, such as a lever arm.
  bool is_left_out(VertexRef vertex) {
    return graph_.vertex_pools()[vertex.pool]->parameter(vertex.slot) &&
           roles_.role(vertex) != Role::kCamera && !entry(vertex).is_observed;
  }
  void add_new(VertexRef vertex) {
    switch (roles_.role(vertex)) {
      case Role::kCamera:
        return add(Camera{.id = next_camera_++, .model = {}, .parameters = {}}, vertex);
      case Role::kPoint:
        return add(Point{.id = next_point_++, .track = {}}, vertex);
      default:
        add_new(Image{.id = next_image_++, .name = std::to_string(graph_.id(vertex)), .features = {}},
                vertex);
    }
  }

  void add(Camera camera, VertexRef vertex) {
    const CameraType* type = camera_type_of(*graph_.vertex_pools()[vertex.pool]);
    const std::span<const double> values = type->values(graph_, vertex);
    std::vector<double> parameters(values.begin(), values.end());
    entry(vertex) = {.index = model_.cameras.size(), .is_changed = camera.parameters != parameters};
    camera.model = type->name;
    camera.parameters = std::move(parameters);
    model_.cameras.push_back(std::move(camera));
  }

  void add_new(Image image, VertexRef vertex) {
    Entry& place = entry(vertex) = {.index = model_.images.size()};
    if (roles_.role(vertex) == Role::kBalImage) {
      const BalVertex& estimate = graph_.estimate(graph_.typed<BalVertex>(vertex));
      const Vector3& values = estimate.get<1>().parameters;
      place.camera = model_.cameras.size();
      model_.cameras.push_back({next_camera_++, "RADIAL", 0, 0, {values[0], 0, 0, values[1], values[2]}});
      set_pose(image, with_turned_axes(estimate.get<0>()));
    } else {
      set_pose(image, graph_.estimate(graph_.typed<SE3>(vertex)));
    }
    model_.images.push_back(std::move(image));
  }

  /// Does nothing if the vertex of the image or its offset is gone.
  void add(Image image, const PosePlace& place) {
    const auto vertex = graph_.find_vertex(place.vertex);
    if (!has_role(vertex, Role::kImage)) return;
    entry(*vertex).is_frame = old_->has_frames;
    SE3 pose = graph_.estimate(graph_.typed<SE3>(*vertex));
    bool is_changed = pose.vector() != place.T_world_rig.vector();
    Entry* in_model = &entry(*vertex);
    if (place.offset) {
      const auto offset = graph_.find_parameter(*place.offset);
      if (!has_role(offset, Role::kImage)) return;
      const SE3& T_rig_camera = graph_.estimate(graph_.typed<SE3>(*offset));
      is_changed |= T_rig_camera.vector() != place.T_rig_camera.vector();
      pose = pose * T_rig_camera;
      in_model = &images_with_offset_[{*vertex, *offset}];
    }
    in_model->index = model_.images.size();
    in_model->is_changed = is_changed;
    if (is_changed) set_pose(image, pose);
    image_indices_[image.id] = in_model->index;
    model_.images.push_back(std::move(image));
  }

  void add(Point point, VertexRef vertex) {
    const Vector3& estimate = graph_.estimate(graph_.typed<Vector3>(vertex));
    entry(vertex) = {.index = model_.points.size(), .is_changed = Vector3(point.position.data()) != estimate};
    point.position = {estimate[0], estimate[1], estimate[2]};
    model_.points.push_back(std::move(point));
  }

  // ---- Observations ----

  /// The first edges belong to the features of the old model that show a point. If an edge is gone, its
  /// feature shows no point anymore.
  void take_old_edges() {
    std::size_t next_edge = 0;
    for (const Image& image : old_->images) {
      const auto kept = image_indices_.find(image.id);
      for (std::size_t i = 0; i < image.features.size(); ++i) {
        if (image.features[i].point == Feature::kNoPoint) continue;
        const std::size_t k = next_edge++;
        if (kept == image_indices_.end()) continue;
        Feature& feature = model_.images[kept->second].features[i];
        if (k >= edges_.size() || !take_old_edge(k, kept->second, i)) feature.point = Feature::kNoPoint;
      }
    }
  }

  bool take_old_edge(std::size_t k, std::size_t image, std::size_t position) {
    if (!pixels_[k]) return false;
    const PixelObservation& seen = *pixels_[k];
    const Entry& point = entry(seen.point);
    Feature& feature = model_.images[image].features[position];
    if (image_entry(seen).index != image || model_.points[point.index].id != feature.point) return false;
    feature.pixel = {seen.pixel[0], seen.pixel[1]};
    take(k, seen, position);
    return true;
  }

  /// Removes the observations whose features do not show their point anymore.
  void take_old_tracks() {
    std::unordered_map<std::uint32_t, const Image*> old_images;
    for (const Image& image : old_->images) old_images[image.id] = &image;
    for (std::size_t i = 0; i < model_.points.size(); ++i) {
      Point& point = model_.points[i];
      const auto is_gone = [&](const Observation& observation) {
        const auto image = image_indices_.find(observation.image);
        if (image == image_indices_.end()) return true;
        return old_images.at(observation.image)->features[observation.feature].point == point.id &&
               model_.images[image->second].features[observation.feature].point != point.id;
      };
      if (std::erase_if(point.track, is_gone) > 0) changed_tracks_.push_back(i);
    }
  }

  void take_new_edges() {
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (!pixels_[k] || is_taken_[k]) continue;
      const PixelObservation& seen = *pixels_[k];
      Image& image = model_.images[image_entry(seen).index];
      const std::size_t index = entry(seen.point).index;
      Point& point = model_.points[index];
      point.track.push_back({image.id, static_cast<std::uint32_t>(image.features.size())});
      image.features.push_back({{seen.pixel[0], seen.pixel[1]}, point.id});
      changed_tracks_.push_back(index);
      take(k, seen, image.features.size() - 1);
    }
  }

  /// `feature` is the position among the features of the image.
  void take(std::size_t k, const PixelObservation& seen, std::size_t feature) {
    is_taken_[k] = true;
    Entry& image = image_entry(seen);
    const std::size_t camera = seen.camera == seen.image ? image.camera : entry(seen.camera).index;
    if (image.camera != kNone && image.camera != camera)
      refuse_for_colmap(fmt::format("pose {} with two cameras", graph_.id(seen.image)));
    image.camera = camera;
    const bool is_changed = image.is_changed || entry(seen.point).is_changed || entry(seen.camera).is_changed;
    seen_.push_back({edges_[k], image.index, feature, camera, entry(seen.point).index, is_changed});
  }

  // ---- What follows from the observations ----

  void set_cameras() {
    for (const VertexRef& vertex : graph_.all_vertices()) {
      const Role role = roles_.role(vertex);
      if ((role == Role::kImage || role == Role::kBalImage) && entry(vertex).index != kNone)
        set_camera(vertex, entry(vertex));
    }
    for (const auto& [vertices, place] : images_with_offset_) set_camera(vertices.first, place);
  }

  void set_camera(VertexRef vertex, const Entry& place) {
    Image& image = model_.images[place.index];
    if (place.camera == kNone) {
      if (place.index < old_images_) return;  // an image without observations has the camera of the file
      refuse_for_colmap(
          fmt::format("pose {} without an edge, so that its camera is unknown", graph_.id(vertex)));
    }
    Camera& camera = model_.cameras[place.camera];
    image.camera = camera.id;
    if (roles_.role(vertex) == Role::kBalImage) move_center(camera, image);
    if (place.camera >= old_cameras_) enlarge(camera, image);
  }

  /// Refuses a graph if a reader of the model would have other poses or errors.
  void check_errors() const {
    std::vector<SE3> poses;
    for (const PosePlace& place : pose_places(model_)) {
      const Image& image = model_.images[poses.size()];
      poses.push_back(place.T_world_camera());
      for (const SE3& pose : {place.T_world_rig, poses.back(), pose_of(image)}) {
        if (!is_moderate(pose))
          refuse_for_colmap(fmt::format("image {} with a pose that overflows", image.id));
      }
    }
    for (const Seen& seen : seen_) {
      if (!seen.is_changed) continue;
      const Image& image = model_.images[seen.image];
      const Point& point = model_.points[seen.point];
      const std::vector<double> error = graph_.error(seen.edge);
      require_equal_error("a COLMAP model", {"image", image.id, static_cast<Id>(point.id)},
                          Vector2(error.data()),
                          error_of(model_.cameras[seen.camera], poses[seen.image],
                                   image.features[seen.feature], Vector3(point.position.data())));
    }
  }

  void set_errors() {
    struct Mean {
      bool is_wanted = false;
      double sum = 0, count = 0;
    };
    std::vector<Mean> means(model_.points.size());
    // Only forget_reprojection_errors() makes NaN, because the readers refuse it.
    for (std::size_t i = 0; i < means.size(); ++i) means[i].is_wanted = std::isnan(model_.points[i].error);
    for (const std::size_t point : changed_tracks_) means[point].is_wanted = true;
    for (const Seen& seen : seen_) means[seen.point].is_wanted |= seen.is_changed;
    for (const Seen& seen : seen_) {
      Mean& mean = means[seen.point];
      if (!mean.is_wanted) continue;
      mean.sum += Vector2(graph_.error(seen.edge).data()).norm();
      ++mean.count;
    }
    for (std::size_t i = 0; i < means.size(); ++i) {
      if (!means[i].is_wanted) continue;
      const double error = means[i].sum / means[i].count;
      model_.points[i].error = std::isfinite(error) ? error : -1;
    }
  }

  struct Seen {
    EdgeRef edge;
    std::size_t image, feature, camera, point;
    bool is_changed;
  };

  const Graph& graph_;
  GraphRoles roles_;
  std::vector<EdgeRef> edges_;
  const SparseModel* old_ = nullptr;
  SparseModel model_;
  std::vector<std::vector<Entry>> entries_;                              // by pool and slot
  std::map<std::pair<VertexRef, VertexRef>, Entry> images_with_offset_;  // by vertex and offset
  std::vector<std::optional<PixelObservation>> pixels_;                  // by position in edges_
  std::vector<bool> is_taken_;                                           // by position in edges_
  std::vector<Seen> seen_;
  std::vector<std::size_t> changed_tracks_;  // indices of points
  std::size_t old_cameras_ = 0, old_images_ = 0;
  std::unordered_map<std::uint32_t, std::size_t> image_indices_;  // by id
  std::uint32_t next_camera_ = 1, next_image_ = 1;
  std::uint64_t next_point_ = 1;
};

}  // namespace

SparseModel model_of(const GraphFileView& file) {
  return ModelMaker(file).make();
}

void forget_reprojection_errors(GraphFile& file) {
  if (!file.model) return;
  SparseModel model = *file.model;
  for (Point& point : model.points) {
    if (!point.track.empty()) point.error = std::numeric_limits<double>::quiet_NaN();
  }
  file.model = std::make_shared<const SparseModel>(std::move(model));
}

std::vector<std::string> model_losses(const GraphFileView& file) {
  const GraphRoles roles(file.graph);
  return reprojection_losses(file.graph, [&](EdgeRef edge) { return roles.observation(edge).has_value(); });
}

SparseModel sparse_model(const GraphFile& file) {
  return model_of({file.graph, file.edges, file.kept, file.model.get()});
}

}  // namespace boxplus
