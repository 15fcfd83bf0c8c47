// SPDX-License-Identifier: BSD-3-Clause
#include "io/model/pose_places.h"

#include <unordered_map>

#include "io/model/model_pose.h"

namespace boxplus {
namespace {

using SensorType = SparseModel::SensorType;

bool is_of_camera(const SparseModel::Data& data) {
  return data.sensor.type == SensorType::kCamera;
}

/// The id of the vertex of a frame that has images.
Id vertex_of(const SparseModel::Frame& frame, const SparseModel::Rig& rig) {
  const SparseModel::Data* first = nullptr;
  for (const SparseModel::Data& data : frame.data) {
    if (!is_of_camera(data)) continue;
    if (data.sensor == rig.sensors.front().sensor) return static_cast<Id>(data.id);
    if (!first) first = &data;
  }
  return first ? static_cast<Id>(first->id) : 0;
}

}  // namespace

std::vector<PosePlace> pose_places(const SparseModel& model) {
  std::vector<PosePlace> places;
  if (!model.has_frames) {
    for (const SparseModel::Image& image : model.images) places.push_back({image.id, pose_of(image), {}, {}});
    return places;
  }
  std::unordered_map<std::uint32_t, const SparseModel::Rig*> rigs;
  for (const SparseModel::Rig& rig : model.rigs) rigs[rig.id] = &rig;
  std::unordered_map<std::uint64_t, PosePlace> place_of;  // by the id of the image
  const Id first_offset = model.first_sensor_parameter();
  for (const SparseModel::Frame& frame : model.frames) {
    const SparseModel::Rig& rig = *rigs.at(frame.rig);
    const PosePlace place{vertex_of(frame, rig), pose_of(frame.pose), {}, {}};
    for (const SparseModel::Data& data : frame.data) {
      if (!is_of_camera(data)) continue;
      PosePlace& of_image = place_of[data.id] = place;
      for (std::size_t i = 1; i < rig.sensors.size(); ++i) {
        if (rig.sensors[i].sensor != data.sensor) continue;
        of_image.offset = first_offset + static_cast<Id>(data.sensor.id);
        of_image.T_rig_camera = pose_of(*rig.sensors[i].pose);
      }
    }
  }
  for (const SparseModel::Image& image : model.images) places.push_back(place_of.at(image.id));
  return places;
}

}  // namespace boxplus
