// SPDX-License-Identifier: BSD-3-Clause
// Writes a COLMAP model, as text or binary.
#pragma once

#include "boxplus/io/file_format.h"
#include "boxplus/io/sparse_model.h"
#include "io/colmap/model_input.h"

namespace boxplus {

/// Appends the fields of one file to a sink.
class ModelOutput {
 public:
  explicit ModelOutput(TextSink sink) : sink_(sink) {}
  virtual ~ModelOutput() = default;
  ModelOutput(const ModelOutput&) = delete;
  ModelOutput& operator=(const ModelOutput&) = delete;

  virtual void begin_file(ModelFile file, std::size_t elements) = 0;
  /// An integer that takes 1, 4 or 8 bytes in a binary file.
  virtual void integer(std::uint64_t value, int bytes) = 0;
  virtual void point_or_none(std::uint64_t value) = 0;
  virtual void number(double value) = 0;
  virtual void camera_type(const CameraType& type) = 0;
  virtual void sensor_type(SparseModel::SensorType type) = 0;
  virtual void image_name(const std::string& name) = 0;
  virtual void begin_list(std::size_t items, bool has_own_line) = 0;
  virtual void end_element() = 0;

  /// Passes the text to the sink if it has at least this many bytes.
  void flush(std::size_t at_least) {
    if (text_.size() < at_least) return;
    sink_(text_);
    text_.clear();
  }

 protected:
  std::string& text() { return text_; }

 private:
  TextSink sink_;
  std::string text_;
};

std::unique_ptr<ModelOutput> text_output(TextSink sink);
std::unique_ptr<ModelOutput> binary_output(TextSink sink);

void write_cameras(const SparseModel& model, ModelOutput& out);
void write_images(const SparseModel& model, ModelOutput& out);
void write_points(const SparseModel& model, ModelOutput& out);
void write_rigs(const SparseModel& model, ModelOutput& out);
void write_frames(const SparseModel& model, ModelOutput& out);
/// Throws InvalidArgument if the names of the images cannot be written as text, or as binary.
void require_names(const SparseModel& model, bool is_text);

}  // namespace boxplus
