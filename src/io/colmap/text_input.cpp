// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "io/characters.h"
#include "io/colmap/model_input.h"
#include "io/number_field.h"

namespace boxplus {
namespace {

/// One element per line, or two for an image. A line that begins with # is a comment.
class TextInput : public ModelInput {
 public:
  explicit TextInput(TextSource source) : ModelInput(std::move(source)) {}

  bool next_element() override {
    do {
      if (!next_line()) return false;
    } while (at_ == end_ || *at_ == '#');
    return true;
  }

  std::uint64_t integer(const char* what, int bytes) override {
    const std::string_view text = field();
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    const std::uint64_t most = ~std::uint64_t{0} >> (64 - 8 * bytes);
    if (text.empty() || stopped != end || error != std::errc() || value > most)
      refuse(fmt::format("{} (an integer from 0 to {})", what, most), text);
    return value;
  }

  std::uint64_t point_or_none(const char* what) override {
    constexpr std::string_view kNone = "-1";
    const std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    if (!rest.starts_with(kNone) || !ends_field(at_ + kNone.size(), end_)) return integer(what, 8);
    field();
    return SparseModel::Feature::kNoPoint;
  }

  double number(const char* what) override {
    const std::string_view text = field();
    Decimal value;
    if (!text.empty()) value = read_number_field(text.data(), text.data() + text.size());
    if (!value.end) refuse(fmt::format("{} (a finite number)", what), text);
    return value.value;
  }

  const CameraType& camera_type() override {
    const std::string_view text = field();
    const CameraType* type = find_camera_type(text);
    if (!type) refuse(fmt::format("a camera model ({})", camera_type_names()), text);
    return *type;
  }

  SparseModel::SensorType sensor_type() override {
    const std::string_view text = field();
    const auto* const found = std::find(kSensorTypes.begin(), kSensorTypes.end(), text);
    if (found == kSensorTypes.end()) refuse("the type of a sensor (CAMERA or IMU)", text);
    return static_cast<SparseModel::SensorType>(found - kSensorTypes.begin());
  }

  std::string image_name() override {
    set_place(here());
    const char* last = end_;
    while (last != at_ && is_blank(last[-1])) --last;
    std::string name(std::exchange(at_, end_), last);
    if (name.empty() || name.find('\0') != std::string::npos) refuse("the name of the image", name);
    return name;
  }

  void begin_list(bool has_own_line) override {
    if (!has_own_line) return;
    end_element();
    if (!next_line()) at_ = end_;  // the last image has no 2-D points, and an editor removed its empty line
  }
  bool next_in_list() override { return at_ != end_; }

  void end_element() override {
    if (at_ != end_) refuse("the end of the line", field());
  }

 private:
  /// Moves to the first field of the next line.
  bool next_line() {
    while (rest_.empty()) {
      if (block_ == source().block_count()) return false;
      rest_ = source().block(block_, memory_);
      if (block_++ == 0) rest_ = without_byte_order_mark(rest_);
    }
    const std::size_t newline = std::min(rest_.find('\n'), rest_.size());
    begin_ = at_ = rest_.data();
    end_ = begin_ + newline;
    rest_.remove_prefix(std::min(newline + 1, rest_.size()));
    ++line_;
    skip_blanks();
    return true;
  }

  /// The next field; empty at the end of the line.
  std::string_view field() {
    set_place(here());
    const char* const begin = at_;
    at_ = std::find_if(at_, end_, is_blank);
    const std::string_view text(begin, static_cast<std::size_t>(at_ - begin));
    skip_blanks();
    return text;
  }
  void skip_blanks() { at_ = std::find_if_not(at_, end_, is_blank); }

  Place here() const { return {line_, at_ - begin_ + 1}; }
  [[noreturn]] void refuse(const std::string& expected, std::string_view text) const {
    fail(place(), fmt::format("expected {}, got {}", expected, in_quotes(text)));
  }

  std::size_t block_ = 0;
  std::string memory_;
  std::string_view rest_;                                         // of the block
  const char *begin_ = nullptr, *at_ = nullptr, *end_ = nullptr;  // of the line
  std::int64_t line_ = 0;
};

}  // namespace

std::unique_ptr<ModelInput> text_input(TextSource source) {
  return std::make_unique<TextInput>(std::move(source));
}

}  // namespace boxplus
