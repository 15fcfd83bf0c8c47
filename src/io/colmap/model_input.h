// SPDX-License-Identifier: BSD-3-Clause
// The fields of one file of a COLMAP model, as text or binary. Both have the same fields in the same order.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "boxplus/base/error.h"
#include "boxplus/io/sparse_model.h"
#include "boxplus/io/text_source.h"
#include "io/model/camera_types.h"

namespace boxplus {

/// Reads a file from its beginning to its end. All functions throw InputError if a field is missing or
/// invalid; `what` names the field.
class ModelInput {
 public:
  /// Where a field is. In a binary file, the line is 1, and the column is the number of its first byte.
  struct Place {
    std::int64_t line = 1, column = 1;
  };

  explicit ModelInput(TextSource source) : source_(std::move(source)) {}
  virtual ~ModelInput() = default;
  ModelInput(const ModelInput&) = delete;
  ModelInput& operator=(const ModelInput&) = delete;

  /// Moves to the next camera, image, point, rig or frame. Returns false at the end of the file. In a binary
  /// file, throws if the declared number of elements does not fit into the file.
  virtual bool next_element() = 0;
  /// An integer that takes 1, 4 or 8 bytes in a binary file.
  virtual std::uint64_t integer(const char* what, int bytes) = 0;
  /// The id of a point, or SparseModel::Feature::kNoPoint, which is −1 in texts.
  virtual std::uint64_t point_or_none(const char* what) = 0;
  virtual double number(const char* what) = 0;
  virtual const CameraType& camera_type() = 0;
  virtual SparseModel::SensorType sensor_type() = 0;
  virtual std::string image_name() = 0;
  /// Moves to the list at the end of an element. In texts, the 2-D points of an image have a line of their
  /// own.
  virtual void begin_list(bool has_own_line) = 0;
  virtual bool next_in_list() = 0;
  /// Throws if the line of a text goes on after the last field.
  virtual void end_element() = 0;

  /// The place of the field that was read last.
  Place place() const { return place_; }
  [[noreturn]] void fail(Place place, const std::string& message) const {
    throw InputError(source_.name(), place.line, place.column, message);
  }

 protected:
  const TextSource& source() const { return source_; }
  void set_place(Place place) { place_ = place; }

 private:
  TextSource source_;
  Place place_;
};

enum class ModelFile : std::uint8_t { kCameras, kImages, kPoints, kRigs, kFrames };

/// By SparseModel::SensorType. Texts have these names, and binary files the index, with 4 bytes.
inline constexpr std::array<std::string_view, 2> kSensorTypes{"CAMERA", "IMU"};

std::unique_ptr<ModelInput> text_input(TextSource source);
std::unique_ptr<ModelInput> binary_input(TextSource source, ModelFile file);

}  // namespace boxplus
