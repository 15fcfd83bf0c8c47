// SPDX-License-Identifier: BSD-3-Clause
#include "io/colmap/model_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <unordered_map>

#include "io/model/model_graph.h"
#include "io/moderate_pose.h"

namespace boxplus {
namespace {

/// As in .g2o files.
constexpr double kNormTolerance = 1e-3;
constexpr std::uint64_t kMostPointId = std::uint64_t{1}
                                       << 62;  // so that the id of its vertex does not overflow

class ModelReader {
 public:
  ModelReader(ModelInput& cameras, ModelInput& images, ModelInput& points)
      : cameras_(cameras), images_(images), points_(points) {}

  SparseModel read() {
    while (cameras_.next_element()) read_camera();
    while (points_.next_element()) read_point();
    while (images_.next_element()) read_image();
    check_tracks();
    return std::move(model_);
  }

 private:
  template <class Ids, class Value>
  static void insert_new(const ModelInput& in, Ids& ids, std::uint64_t id, const Value& value,
                         const char* what) {
    if (!ids.try_emplace(id, value).second)
      in.fail(in.place(), fmt::format("expected the id of a new {}, got {} again", what, id));
  }

  void read_camera() {
    SparseModel::Camera& camera = model_.cameras.emplace_back();
    camera.id = static_cast<std::uint32_t>(cameras_.integer("the id of a camera", 4));
    insert_new(cameras_, camera_indices_, camera.id, model_.cameras.size() - 1, "camera");
    const CameraType& type = cameras_.camera_type();
    camera.model = type.name;
    camera.width = cameras_.integer("the width of the images", 8);
    camera.height = cameras_.integer("the height of the images", 8);
    for (int i = 0; i < type.parameters; ++i)
      camera.parameters.push_back(cameras_.number("a parameter of the camera"));
    cameras_.end_element();
  }

  void read_point() {
    SparseModel::Point& point = model_.points.emplace_back();
    point.id = points_.integer("the id of a point", 8);
    if (point.id > kMostPointId)
      points_.fail(points_.place(),
                   fmt::format("expected the id of a point (at most 2^62), got {}", point.id));
    insert_new(points_, point_indices_, point.id, model_.points.size() - 1, "point");
    for (double& value : point.position) value = points_.number("a coordinate of the point");
    for (std::uint8_t& value : point.color)
      value = static_cast<std::uint8_t>(points_.integer("a color of the point", 1));
    point.error = points_.number("the reprojection error of the point");
    points_.begin_list(false);
    while (points_.next_in_list()) {
      const std::uint64_t image = points_.integer("the id of an image", 4);
      track_places_.push_back(points_.place());
      const std::uint64_t feature = points_.integer("the index of a 2-D point", 4);
      point.track.push_back({static_cast<std::uint32_t>(image), static_cast<std::uint32_t>(feature)});
    }
  }

  void read_image() {
    SparseModel::Image& image = model_.images.emplace_back();
    image.id = static_cast<std::uint32_t>(images_.integer("the id of an image", 4));
    insert_new(images_, image_indices_, image.id, model_.images.size() - 1, "image");
    const SparseModel::Pose pose = read_pose(images_, fmt::format("image {}", image.id));
    image.rotation = pose.rotation;
    image.translation = pose.translation;
    image.camera = static_cast<std::uint32_t>(images_.integer("the id of the camera", 4));
    if (!camera_indices_.contains(image.camera))
      images_.fail(images_.place(),
                   fmt::format("expected the id of a camera, got {}, which does not exist", image.camera));
    image.name = images_.image_name();
    images_.begin_list(true);
    while (images_.next_in_list()) read_feature(image);
    images_.end_element();
  }

  void read_feature(SparseModel::Image& image) {
    SparseModel::Feature& feature = image.features.emplace_back();
    for (double& value : feature.pixel) value = images_.number("a coordinate of a 2-D point");
    feature.point = images_.point_or_none("the id of a point, or -1");
    if (feature.point != SparseModel::Feature::kNoPoint && !point_indices_.contains(feature.point))
      images_.fail(images_.place(),
                   fmt::format("expected the id of a point, got {}, which does not exist", feature.point));
  }

  void check_tracks() const {
    auto place = track_places_.begin();
    for (const SparseModel::Point& point : model_.points) {
      for (const SparseModel::Observation& observation : point.track) {
        const auto image = image_indices_.find(observation.image);
        if (image == image_indices_.end())
          points_.fail(*place, fmt::format("expected the id of an image, got {}, which does not exist",
                                           observation.image));
        const std::size_t features = model_.images[image->second].features.size();
        if (observation.feature >= features)
          points_.fail(*place, fmt::format("expected a 2-D point of image {}, which has {}, got index {}",
                                           observation.image, features, observation.feature));
        ++place;
      }
    }
  }

  ModelInput &cameras_, &images_, &points_;
  SparseModel model_;
  std::unordered_map<std::uint64_t, std::size_t> camera_indices_, image_indices_, point_indices_;
  std::vector<ModelInput::Place> track_places_;  // of all observations, in the order of the points
};

}  // namespace

SparseModel read_model(ModelInput& cameras, ModelInput& images, ModelInput& points) {
  return ModelReader(cameras, images, points).read();
}

SparseModel::Pose read_pose(ModelInput& in, const std::string& owner) {
  SparseModel::Pose pose;
  std::optional<ModelInput::Place> place;
  for (double& value : pose.rotation) {
    value = in.number("a quaternion's coefficient");
    if (!place) place = in.place();
  }
  for (double& value : pose.translation) value = in.number("a coordinate of the translation");
  const auto& q = pose.rotation;
  const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!(std::abs(norm - 1) <= kNormTolerance))
    in.fail(*place, fmt::format("{}: expected a quaternion QW QX QY QZ of length 1 (± {}), got one of "
                                "length {:.6g}",
                                owner, kNormTolerance, norm));
  if (!is_moderate(pose_of(pose)))
    in.fail(in.place(),
            fmt::format("{}: expected a pose with moderate values, got values that overflow", owner));
  return pose;
}

}  // namespace boxplus
