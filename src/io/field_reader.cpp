// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/field_reader.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "boxplus/base/error.h"
#include "io/characters.h"

namespace boxplus {
namespace {

/// Whether `parse` accepts the whole `text`. Skips a leading +, which `parse` does not accept.
template <class Parse>
bool is_all_of(std::string_view text, Parse&& parse) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stopped, error] = parse(text.data(), end);
  return error == std::errc() && stopped == end;
}

}  // namespace

/// The position of the field that has `field` fields before it, or the end of the line if there is no such
/// field.
std::size_t FieldReader::position_of(std::size_t field) const {
  const auto next = [this](std::size_t at, bool blank) {
    while (at < line_.size() && is_blank(line_[at]) == blank) ++at;
    return at;
  };
  std::size_t at = next(0, true);
  for (; field > 0 && at < line_.size(); --field) at = next(next(at, false), true);
  return at;
}

void FieldReader::go_on_with_text() {
  if (!is_converted_) return;
  passed_ = passed();
  position_ = position_of(passed_);
  first_ = next_ = end_ = integers_end_ = nullptr;
  is_converted_ = false;
}

void FieldReader::skip_blanks() {
  while (position_ < line_.size() && is_blank(line_[position_])) ++position_;
}

void FieldReader::note(std::string text) {
  note_ = std::move(text);
}

bool FieldReader::at_end() {
  if (is_converted_) return next_ == end_;
  skip_blanks();
  return position_ == line_.size() || line_[position_] == '#';
}

void FieldReader::fail(FieldPlace place, const std::string& message) const {
  fail_at(position_of(place.fields_before_), message);
}

void FieldReader::fail_at(std::size_t position, const std::string& message) const {
  throw InputError(std::string(file_), line_number_, static_cast<std::int64_t>(position) + 1, message);
}

void FieldReader::refuse(std::size_t position, std::string_view expected, std::string_view came) const {
  fail_at(position, fmt::format("expected {}, got {}", expected, in_quotes(came)));
}

std::string_view FieldReader::token(std::string_view what) {
  go_on_with_text();
  skip_blanks();
  const std::size_t begin = position_;
  while (position_ < line_.size() && !is_blank(line_[position_])) ++position_;
  if (begin == position_) refuse(begin, what, {});
  ++passed_;
  return line_.substr(begin, position_ - begin);
}

double FieldReader::number_from_text(std::string_view what) {
  const std::string_view text = token(what);
  double value = 0;
  const bool read = is_all_of(text, [&](const char* begin, const char* end) {
    const auto result = fast_float::from_chars(begin, end, value);
    return std::pair(result.ptr, result.ec);
  });
  if (!read || !std::isfinite(value))
    refuse(position_ - text.size(), fmt::format("{} (a finite number)", what), text);
  return value;
}

void FieldReader::numbers(double* out, int count, std::string_view what) {
  for (int i = 0; i < count; ++i) out[i] = number(what);
}

std::int64_t FieldReader::integer_from_text(std::string_view what) {
  const std::string_view text = token(what);
  std::int64_t value = 0;
  bool is_too_large = false;
  const bool read = is_all_of(text, [&](const char* begin, const char* end) {
    const auto result = std::from_chars(begin, end, value);
    is_too_large = result.ec == std::errc::result_out_of_range && result.ptr == end;
    return std::pair(result.ptr, result.ec);
  });
  if (!read) {
    using Limits = std::numeric_limits<std::int64_t>;
    std::string limit;
    if (is_too_large)
      limit =
          text[0] == '-' ? fmt::format(" from {}", Limits::min()) : fmt::format(" up to {}", Limits::max());
    refuse(position_ - text.size(), fmt::format("{} (an integer{})", what, limit), text);
  }
  return value;
}

bool FieldReader::accept(std::string_view text) {
  go_on_with_text();
  if (at_end()) return false;
  const std::size_t begin = position_;
  if (token("a field") == text) return true;
  position_ = begin;
  --passed_;
  return false;
}

void FieldReader::expect_end() {
  if (at_end()) return;
  go_on_with_text();
  const std::size_t begin = position_;
  refuse(begin, "the end of the line", token("a field"));
}

void FieldWriter::separate() {
  if (!out_->empty() && out_->back() != '\n') out_->push_back(' ');
}

void FieldWriter::token(std::string_view text) {
  separate();
  out_->append(text);
}

void FieldWriter::number(double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  token({text, static_cast<std::size_t>(result.ptr - text)});
}

void FieldWriter::integer(std::int64_t value) {
  char text[24];
  const auto result = std::to_chars(text, text + sizeof text, value);
  token({text, static_cast<std::size_t>(result.ptr - text)});
}

}  // namespace boxplus
