// SPDX-License-Identifier: BSD-3-Clause
#include "io/colmap/model_output.h"

#include <bit>
#include <charconv>

#include "boxplus/io/field_reader.h"
#include "io/characters.h"

namespace boxplus {
namespace {

constexpr std::size_t kPiece = std::size_t{1} << 18;

class TextOutput : public ModelOutput {
 public:
  using ModelOutput::ModelOutput;

  void begin_file(ModelFile file, std::size_t elements) override {
    constexpr std::array kTitles{
        "# CAMERA_ID MODEL WIDTH HEIGHT PARAMETERS...\n# Cameras: ",
        "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME\n# (X Y POINT3D_ID)...\n# Images: ",
        "# POINT3D_ID X Y Z R G B ERROR (IMAGE_ID POINT2D_INDEX)...\n# Points: ",
        "# RIG_ID NUM_SENSORS REF_SENSOR_TYPE REF_SENSOR_ID (SENSOR_TYPE SENSOR_ID HAS_POSE [QW QX QY QZ TX "
        "TY "
        "TZ])...\n# Rigs: ",
        "# FRAME_ID RIG_ID QW QX QY QZ TX TY TZ NUM_DATA_IDS (SENSOR_TYPE SENSOR_ID DATA_ID)...\n# Frames: "};
    text() += kTitles[static_cast<std::size_t>(file)];
    text() += std::to_string(elements);
    end_element();
  }
  void integer(std::uint64_t value, int /*bytes*/) override { token(std::to_string(value)); }
  void point_or_none(std::uint64_t value) override {
    if (value == SparseModel::Feature::kNoPoint) return token("-1");
    integer(value, 8);
  }
  void number(double value) override { FieldWriter(text()).number(value); }
  void camera_type(const CameraType& type) override { token(type.name); }
  void sensor_type(SparseModel::SensorType type) override {
    token(kSensorTypes[static_cast<std::size_t>(type)]);
  }
  void image_name(const std::string& name) override { token(name); }
  void begin_list(std::size_t /*items*/, bool has_own_line) override {
    if (has_own_line) end_element();
  }
  void end_element() override { text().push_back('\n'); }

 private:
  void token(std::string_view field) { FieldWriter(text()).token(field); }
};

class BinaryOutput : public ModelOutput {
 public:
  using ModelOutput::ModelOutput;

  void begin_file(ModelFile /*file*/, std::size_t elements) override { integer(elements, 8); }
  void integer(std::uint64_t value, int bytes) override {
    for (int i = 0; i < bytes; ++i) text().push_back(static_cast<char>((value >> (8 * i)) & 0xFF));
  }
  void point_or_none(std::uint64_t value) override { integer(value, 8); }
  void number(double value) override { integer(std::bit_cast<std::uint64_t>(value), 8); }
  void camera_type(const CameraType& type) override { integer(static_cast<std::uint64_t>(type.model_id), 4); }
  void sensor_type(SparseModel::SensorType type) override { integer(static_cast<std::uint64_t>(type), 4); }
  void image_name(const std::string& name) override { text().append(name.c_str(), name.size() + 1); }
  void begin_list(std::size_t items, bool /*has_own_line*/) override { integer(items, 8); }
  void end_element() override {}
};

template <class Values>
void write_numbers(const Values& values, ModelOutput& out) {
  for (const double value : values) out.number(value);
}

void write_pose(const SparseModel::Pose& pose, ModelOutput& out) {
  write_numbers(pose.rotation, out);
  write_numbers(pose.translation, out);
}

void write_sensor(const SparseModel::Sensor& sensor, ModelOutput& out) {
  out.sensor_type(sensor.type);
  out.integer(sensor.id, 4);
}

void end_element(ModelOutput& out) {
  out.end_element();
  out.flush(kPiece);
}

}  // namespace

std::unique_ptr<ModelOutput> text_output(TextSink sink) {
  return std::make_unique<TextOutput>(sink);
}

std::unique_ptr<ModelOutput> binary_output(TextSink sink) {
  return std::make_unique<BinaryOutput>(sink);
}

void write_cameras(const SparseModel& model, ModelOutput& out) {
  out.begin_file(ModelFile::kCameras, model.cameras.size());
  for (const SparseModel::Camera& camera : model.cameras) {
    out.integer(camera.id, 4);
    out.camera_type(*find_camera_type(camera.model));
    out.integer(camera.width, 8);
    out.integer(camera.height, 8);
    write_numbers(camera.parameters, out);
    end_element(out);
  }
  out.flush(1);
}

void write_images(const SparseModel& model, ModelOutput& out) {
  out.begin_file(ModelFile::kImages, model.images.size());
  for (const SparseModel::Image& image : model.images) {
    out.integer(image.id, 4);
    write_numbers(image.rotation, out);
    write_numbers(image.translation, out);
    out.integer(image.camera, 4);
    out.image_name(image.name);
    out.begin_list(image.features.size(), true);
    for (const SparseModel::Feature& feature : image.features) {
      write_numbers(feature.pixel, out);
      out.point_or_none(feature.point);
    }
    end_element(out);
  }
  out.flush(1);
}

void write_points(const SparseModel& model, ModelOutput& out) {
  out.begin_file(ModelFile::kPoints, model.points.size());
  for (const SparseModel::Point& point : model.points) {
    out.integer(point.id, 8);
    write_numbers(point.position, out);
    for (const std::uint8_t channel : point.color) out.integer(channel, 1);
    out.number(point.error);
    out.begin_list(point.track.size(), false);
    for (const SparseModel::Observation& observation : point.track) {
      out.integer(observation.image, 4);
      out.integer(observation.feature, 4);
    }
    end_element(out);
  }
  out.flush(1);
}

void write_rigs(const SparseModel& model, ModelOutput& out) {
  out.begin_file(ModelFile::kRigs, model.rigs.size());
  for (const SparseModel::Rig& rig : model.rigs) {
    out.integer(rig.id, 4);
    out.integer(rig.sensors.size(), 4);
    for (std::size_t i = 0; i < rig.sensors.size(); ++i) {
      write_sensor(rig.sensors[i].sensor, out);
      if (i == 0) continue;  // the reference sensor has no pose
      const std::optional<SparseModel::Pose>& pose = rig.sensors[i].pose;
      out.integer(static_cast<std::uint64_t>(pose.has_value()), 1);
      if (pose) write_pose(*pose, out);
    }
    end_element(out);
  }
  out.flush(1);
}

void write_frames(const SparseModel& model, ModelOutput& out) {
  out.begin_file(ModelFile::kFrames, model.frames.size());
  for (const SparseModel::Frame& frame : model.frames) {
    out.integer(frame.id, 4);
    out.integer(frame.rig, 4);
    write_pose(frame.pose, out);
    out.integer(frame.data.size(), 4);
    for (const SparseModel::Data& data : frame.data) {
      write_sensor(data.sensor, out);
      out.integer(data.id, 8);
    }
    end_element(out);
  }
  out.flush(1);
}

void require_names(const SparseModel& model, bool is_text) {
  for (const SparseModel::Image& image : model.images) {
    const std::string& name = image.name;
    if (name.find('\0') != std::string::npos)
      throw InvalidArgument("cannot write a COLMAP model: image " + std::to_string(image.id) +
                            ": expected a name without bytes of value 0, got " + in_quotes(name));
    if (is_text && (name.empty() || is_blank(name.front()) || is_blank(name.back()) ||
                    name.find('\n') != std::string::npos))
      throw InvalidArgument("cannot write COLMAP's text: image " + std::to_string(image.id) +
                            ": expected a name of one line without blanks around it, got " + in_quotes(name));
  }
}

}  // namespace boxplus
