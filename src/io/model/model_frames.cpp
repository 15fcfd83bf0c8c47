// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/model_frames.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "io/model/model_graph.h"
#include "io/model/pose_places.h"

namespace boxplus {
namespace {

using Data = SparseModel::Data;
using Frame = SparseModel::Frame;
using Image = SparseModel::Image;
using Rig = SparseModel::Rig;
using Role = GraphRoles::Role;
using Sensor = SparseModel::Sensor;
using SensorType = SparseModel::SensorType;

bool is_image(const Data& data) {
  return data.sensor.type == SensorType::kCamera;
}

class FrameMaker {
 public:
  FrameMaker(SparseModel& model, const SparseModel& old, const GraphRoles& roles)
      : model_(model), old_(old), roles_(roles), places_(pose_places(old)) {
    for (std::size_t i = 0; i < old.images.size(); ++i) old_images_[old.images[i].id] = i;
    for (const Image& image : model.images) images_[image.id] = &image;
  }

  void make() {
    model_.has_frames = true;
    add_rigs();
    for (const Frame& frame : old_.frames) add(frame);
    for (const Image& image : model_.images) {
      if (!old_images_.contains(image.id)) add_frame_of(image);
    }
  }

 private:
  void add_rigs() {
    std::unordered_set<std::uint32_t> cameras;
    for (const SparseModel::Camera& camera : model_.cameras) cameras.insert(camera.id);
    model_.rigs = old_.rigs;
    for (Rig& rig : model_.rigs) {
      next_rig_ = std::max(next_rig_, rig.id + 1);
      for (SparseModel::RigSensor& mounted : rig.sensors) {
        if (mounted.sensor.type != SensorType::kCamera) continue;
        if (!cameras.contains(mounted.sensor.id))
          refuse_for_colmap(fmt::format("rig {} without its camera {}", rig.id, mounted.sensor.id));
        if (mounted.pose) update(*mounted.pose, mounted.sensor.id);
      }
    }
  }

  /// Takes the pose of a camera on its rig from the graph, which has it if there are images of this camera.
  void update(SparseModel::Pose& pose, std::uint32_t camera) const {
    const Graph& graph = roles_.graph();
    const auto offset = graph.find_parameter(old_.first_sensor_parameter() + static_cast<Id>(camera));
    if (!offset || roles_.role(*offset) != Role::kImage) return;
    const SE3& T_rig_camera = graph.estimate(graph.typed<SE3>(*offset));
    if (pose_of(pose).vector() != T_rig_camera.vector()) pose = pose_in_file(T_rig_camera);
  }

  void add(Frame frame) {
    next_frame_ = std::max(next_frame_, frame.id + 1);
    const auto is_of_camera = [](const Data& data) { return is_image(data); };
    const auto before = std::count_if(frame.data.begin(), frame.data.end(), is_of_camera);
    std::erase_if(frame.data, [&](const Data& data) { return is_image(data) && !images_.contains(data.id); });
    const auto first = std::find_if(frame.data.begin(), frame.data.end(), is_of_camera);
    if (first == frame.data.end()) {
      if (before == 0) model_.frames.push_back(std::move(frame));
      return;
    }
    for (const Data& data : frame.data) {
      if (is_image(data)) require_camera(*images_.at(data.id), data.sensor.id);
    }
    const Graph& graph = roles_.graph();
    const PosePlace& place = places_[old_images_.at(first->id)];
    const SE3& T_world_rig = graph.estimate(graph.vertex<SE3>(place.vertex));
    if (place.T_world_rig.vector() != T_world_rig.vector()) frame.pose = pose_in_file(T_world_rig);
    model_.frames.push_back(std::move(frame));
  }

  static void require_camera(const Image& image, std::uint32_t camera) {
    if (image.camera != camera)
      refuse_for_colmap(fmt::format("image {} of camera {}, which its frame has from camera {}", image.id,
                                    image.camera, camera));
  }

  void add_frame_of(const Image& image) {
    const Sensor sensor{SensorType::kCamera, image.camera};
    model_.frames.push_back({next_frame_++,
                             rig_for(sensor, image.id),
                             {image.rotation, image.translation},
                             {Data{sensor, image.id}}});
  }

  /// The id of the rig whose reference sensor is this one.
  std::uint32_t rig_for(const Sensor& sensor, std::uint32_t image) {
    for (const Rig& rig : model_.rigs) {
      for (std::size_t i = 0; i < rig.sensors.size(); ++i) {
        if (rig.sensors[i].sensor != sensor) continue;
        if (i == 0) return rig.id;
        refuse_for_colmap(
            fmt::format("the new image {} of camera {}, which is not the reference sensor of rig {}", image,
                        sensor.id, rig.id));
      }
    }
    model_.rigs.push_back({next_rig_, {{sensor, {}}}});
    return next_rig_++;
  }

  SparseModel& model_;
  const SparseModel& old_;
  const GraphRoles& roles_;
  std::vector<PosePlace> places_;                              // of the old images
  std::unordered_map<std::uint64_t, std::size_t> old_images_;  // by id
  std::unordered_map<std::uint64_t, const Image*> images_;     // by id
  std::uint32_t next_rig_ = 1, next_frame_ = 1;
};

}  // namespace

void add_frames(SparseModel& model, const SparseModel& old, const GraphRoles& roles) {
  FrameMaker(model, old, roles).make();
}

}  // namespace boxplus
