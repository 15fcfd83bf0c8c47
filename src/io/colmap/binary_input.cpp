// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "io/colmap/model_input.h"

namespace boxplus {
namespace {

/// Little-endian values without any padding. The number of elements, and the number of items of a list, come
/// before them.
class BinaryInput : public ModelInput {
 public:
  BinaryInput(TextSource source, ModelFile file)
      : ModelInput(std::move(source)), file_(file), bytes_(this->source().text(memory_)) {}

  bool next_element() override {
    if (!is_counted_) {
      elements_ = count(names().elements, names().element_bytes);
      is_counted_ = true;
    }
    if (elements_ == 0) {
      if (at_ < bytes_.size()) {
        set_place(here());
        fail(place(), fmt::format("expected the end of the file, got {} more bytes", bytes_.size() - at_));
      }
      return false;
    }
    --elements_;
    return true;
  }

  std::uint64_t integer(const char* what, int bytes) override {
    set_place(here());
    const auto size = static_cast<std::size_t>(bytes);
    if (bytes_.size() - at_ < size)
      fail(place(), fmt::format("expected {} ({} bytes), got the end of the file", what, bytes));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
      value |= std::uint64_t{static_cast<std::uint8_t>(bytes_[at_ + i])} << (8 * i);
    at_ += size;
    return value;
  }

  std::uint64_t point_or_none(const char* what) override { return integer(what, 8); }

  double number(const char* what) override {
    const auto value = std::bit_cast<double>(integer(what, 8));
    if (!std::isfinite(value))
      fail(place(), fmt::format("expected {} (a finite number), got {}", what, value));
    return value;
  }

  const CameraType& camera_type() override {
    const std::uint64_t id = integer("the camera model", 4);
    const CameraType* type = find_camera_type(id);
    if (!type)
      fail(place(), fmt::format("expected a camera model from 0 to {} ({}), got {}",
                                camera_types().size() - 1, camera_type_names(), id));
    return *type;
  }

  SparseModel::SensorType sensor_type() override {
    const std::uint64_t type = integer("the type of a sensor", 4);
    if (type >= kSensorTypes.size())
      fail(place(), fmt::format("expected the type of a sensor (0 for a camera, 1 for an IMU), got {}",
                                static_cast<std::int32_t>(type)));
    return static_cast<SparseModel::SensorType>(type);
  }

  std::string image_name() override {
    set_place(here());
    const std::size_t end = bytes_.find('\0', at_);
    if (end == std::string_view::npos)
      fail(place(), "expected the name of the image and a byte of value 0, got the end of the file");
    const std::string_view name = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return std::string(name);
  }

  void begin_list(bool /*has_own_line*/) override { items_ = count(names().items, names().item_bytes); }
  bool next_in_list() override {
    if (items_ == 0) return false;
    --items_;
    return true;
  }
  void end_element() override {}

 private:
  struct Names {
    const char* elements;
    std::uint64_t element_bytes;  // at least
    const char* items;
    std::uint64_t item_bytes;
  };
  const Names& names() const {
    static constexpr Names kNames[] = {{"cameras", 48, "parameters", 8},
                                       {"images", 73, "2-D points of the image", 24},
                                       {"points", 51, "observations of the point", 8},
                                       {"rigs", 8, "", 1},
                                       {"frames", 68, "", 1}};
    return kNames[static_cast<std::size_t>(file_)];
  }

  /// A number of things that have at least `bytes` bytes each. Throws if they do not fit into the file.
  std::uint64_t count(const char* things, std::uint64_t bytes) {
    const std::uint64_t value = integer(fmt::format("the number of {}", things).c_str(), 8);
    const std::uint64_t most = (bytes_.size() - at_) / bytes;
    if (value > most)
      fail(place(), fmt::format("expected at most {} {}, because the file has only {} more bytes, got {}",
                                most, things, bytes_.size() - at_, value));
    return value;
  }

  Place here() const { return {1, static_cast<std::int64_t>(at_) + 1}; }

  ModelFile file_;
  std::string memory_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::uint64_t elements_ = 0, items_ = 0;
  bool is_counted_ = false;
};

}  // namespace

std::unique_ptr<ModelInput> binary_input(TextSource source, ModelFile file) {
  return std::make_unique<BinaryInput>(std::move(source), file);
}

}  // namespace boxplus
