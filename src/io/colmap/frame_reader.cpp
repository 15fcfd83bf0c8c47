// SPDX-License-Identifier: BSD-3-Clause
#include "io/colmap/frame_reader.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "io/colmap/model_reader.h"
#include "io/model/model_graph.h"

namespace boxplus {
namespace {

using Frame = SparseModel::Frame;
using Image = SparseModel::Image;
using Rig = SparseModel::Rig;
using RigSensor = SparseModel::RigSensor;
using Sensor = SparseModel::Sensor;
using SensorType = SparseModel::SensorType;

std::string name_of(const Sensor& sensor) {
  return fmt::format("{} {}", sensor.type == SensorType::kCamera ? "camera" : "IMU", sensor.id);
}

class FrameReader {
 public:
  FrameReader(ModelInput& rigs, ModelInput& frames, SparseModel& model)
      : rigs_(rigs), frames_(frames), model_(model) {
    model.has_frames = true;
    for (const SparseModel::Camera& camera : model.cameras) cameras_.insert(camera.id);
    for (const Image& image : model.images) images_[image.id] = &image;
  }

  void read() {
    while (rigs_.next_element()) read_rig();
    while (frames_.next_element()) read_frame();
    for (const Image& image : model_.images) {
      if (!images_in_frames_.contains(image.id))
        frames_.fail(frames_.place(), fmt::format("expected a frame of image {}, got none", image.id));
    }
  }

 private:
  /// A sensor of a rig.
  struct Mount {
    std::size_t rig = 0, sensor = 0;  // indices
  };

  static std::uint32_t id(ModelInput& in, const char* what) {
    return static_cast<std::uint32_t>(in.integer(what, 4));
  }
  static void require_new(const ModelInput& in, bool is_new, const char* what, std::uint32_t id) {
    if (!is_new) in.fail(in.place(), fmt::format("expected the id of a new {}, got {} again", what, id));
  }

  Sensor read_sensor(ModelInput& in) const {
    const SensorType type = in.sensor_type();
    const Sensor sensor{type, id(in, "the id of a sensor")};
    if (type == SensorType::kCamera && !cameras_.contains(sensor.id))
      in.fail(in.place(),
              fmt::format("expected the id of a camera, got {}, which does not exist", sensor.id));
    return sensor;
  }

  void read_rig() {
    Rig& rig = model_.rigs.emplace_back();
    rig.id = id(rigs_, "the id of a rig");
    const std::size_t index = model_.rigs.size() - 1;
    require_new(rigs_, rig_indices_.try_emplace(rig.id, index).second, "rig", rig.id);
    const std::uint64_t count = rigs_.integer("the number of sensors", 4);
    for (std::size_t i = 0; i < count; ++i) {
      RigSensor& sensor = rig.sensors.emplace_back(RigSensor{read_sensor(rigs_), {}});
      if (!mounts_.try_emplace(sensor.sensor, Mount{index, i}).second)
        rigs_.fail(rigs_.place(), fmt::format("expected a sensor that is on no rig yet, got {} again",
                                              name_of(sensor.sensor)));
      if (i > 0 && read_has_pose())
        sensor.pose = read_pose(rigs_, fmt::format("{} of rig {}", name_of(sensor.sensor), rig.id));
    }
    rigs_.end_element();
  }

  bool read_has_pose() {
    const std::uint64_t value = rigs_.integer("whether the sensor has a pose", 1);
    if (value > 1)
      rigs_.fail(rigs_.place(),
                 fmt::format("expected 1 if the sensor has a pose, otherwise 0, got {}", value));
    return value == 1;
  }

  void read_frame() {
    Frame& frame = model_.frames.emplace_back();
    frame.id = id(frames_, "the id of a frame");
    require_new(frames_, frame_ids_.insert(frame.id).second, "frame", frame.id);
    frame.rig = id(frames_, "the id of the rig");
    const auto rig = rig_indices_.find(frame.rig);
    if (rig == rig_indices_.end())
      frames_.fail(frames_.place(),
                   fmt::format("expected the id of a rig, got {}, which does not exist", frame.rig));
    frame.pose = read_pose(frames_, fmt::format("frame {}", frame.id));
    const std::uint64_t count = frames_.integer("the number of data", 4);
    std::set<Sensor> cameras;
    for (std::uint64_t i = 0; i < count; ++i) {
      SparseModel::Data& data = frame.data.emplace_back();
      data.sensor = read_sensor(frames_);
      const auto mount = mounts_.find(data.sensor);
      if (mount == mounts_.end() || mount->second.rig != rig->second)
        frames_.fail(frames_.place(),
                     fmt::format("expected a sensor of rig {}, got {}", frame.rig, name_of(data.sensor)));
      const bool is_new = data.sensor.type != SensorType::kCamera || cameras.insert(data.sensor).second;
      if (!is_new)
        frames_.fail(frames_.place(),
                     fmt::format("frame {}: expected one image of each camera, got two of {}", frame.id,
                                 name_of(data.sensor)));
      data.id = frames_.integer("the id of the data of a sensor", 8);
      if (data.sensor.type == SensorType::kCamera) check_image(frame, data, mount->second);
    }
    frames_.end_element();
  }

  void check_image(const Frame& frame, const SparseModel::Data& data, const Mount& mount) {
    const auto refuse = [&](const std::string& message) { frames_.fail(frames_.place(), message); };
    const auto found = images_.find(data.id);
    if (found == images_.end())
      refuse(fmt::format("expected the id of an image, got {}, which does not exist", data.id));
    const Image& image = *found->second;
    if (image.camera != data.sensor.id)
      refuse(fmt::format("expected an image of camera {}, got image {} of camera {}", data.sensor.id,
                         image.id, image.camera));
    if (!images_in_frames_.insert(image.id).second)
      refuse(fmt::format("expected an image that is in no frame yet, got {} again", image.id));
    const RigSensor& sensor = model_.rigs[mount.rig].sensors[mount.sensor];
    if (mount.sensor > 0 && !sensor.pose)
      refuse(fmt::format(
          "expected an image of a camera whose pose on rig {} is known, got image {} of camera {}", frame.rig,
          image.id, image.camera));
    check_pose(frame, image, mount.sensor > 0 ? pose_of(*sensor.pose) : SE3());
  }

  /// COLMAP writes both poses, and reads that of the frame.
  void check_pose(const Frame& frame, const Image& image, const SE3& T_rig_camera) const {
    constexpr double kTolerance = 1e-5;  // in radians, and relative to the distance from the origin
    const SE3 of_frame = pose_of(frame.pose) * T_rig_camera, of_image = pose_of(image);
    const double angle = SO3(of_frame.inverse_times(of_image).quaternion()).rotation_vector().norm();
    const double distance = (of_frame.translation() - of_image.translation()).norm();
    if (angle <= kTolerance && distance <= kTolerance * (1 + of_image.translation().norm())) return;
    frames_.fail(frames_.place(),
                 fmt::format("expected frame {} where image {} is, got a pose that differs by {:.6g} rad and "
                             "{:.6g}",
                             frame.id, image.id, angle, distance));
  }

  ModelInput &rigs_, &frames_;
  SparseModel& model_;
  std::unordered_set<std::uint32_t> cameras_, frame_ids_, images_in_frames_;
  std::unordered_map<std::uint64_t, const Image*> images_;
  std::unordered_map<std::uint32_t, std::size_t> rig_indices_;
  std::map<Sensor, Mount> mounts_;
};

}  // namespace

void read_frames(ModelInput& rigs, ModelInput& frames, SparseModel& model) {
  FrameReader(rigs, frames, model).read();
}

}  // namespace boxplus
