// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/field_reader.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "boxplus/base/error.h"
#include "io/characters.h"

namespace boxplus {
namespace {

/// The number that is all of `text`, but for a leading +; false where it is none.
template <class Parse>
bool is_all_of(std::string_view text, Parse&& parse) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const char* end = text.data() + text.size();
  const auto [stopped, error] = parse(text.data(), end);
  return error == std::errc() && stopped == end;
}

}  // namespace

void FieldReader::skip_blanks() {
  while (position_ < line_.size() && is_blank(line_[position_])) ++position_;
}

void FieldReader::require_text() const {
  if (is_numeric_) throw NotNumeric();
}

void FieldReader::note(std::string text) {
  note_ = std::move(text);
}

bool FieldReader::at_end() {
  if (is_numeric_) return next_ == end_;
  skip_blanks();
  return position_ == line_.size() || line_[position_] == '#';
}

std::int64_t FieldReader::column() {
  if (is_numeric_) return 0;
  skip_blanks();
  return static_cast<std::int64_t>(position_) + 1;
}

void FieldReader::fail(std::int64_t column, const std::string& message) const {
  throw InputError(std::string(file_), line_number_, column, message);
}

void FieldReader::fail_at(std::size_t begin, std::string_view expected, std::string_view came) const {
  fail(static_cast<std::int64_t>(begin) + 1, fmt::format("expected {}, got {}", expected, quoted(came)));
}

std::string_view FieldReader::word(std::string_view what) {
  require_text();
  skip_blanks();
  const std::size_t begin = position_;
  while (position_ < line_.size() && !is_blank(line_[position_])) ++position_;
  if (begin == position_) fail_at(begin, what, {});
  return line_.substr(begin, position_ - begin);
}

double FieldReader::number_from_text(std::string_view what) {
  const std::string_view text = word(what);
  double value = 0;
  const bool read = is_all_of(text, [&](const char* begin, const char* end) {
    const auto result = fast_float::from_chars(begin, end, value);
    return std::pair(result.ptr, result.ec);
  });
  if (!read || !std::isfinite(value))
    fail_at(position_ - text.size(), fmt::format("{} (a finite number)", what), text);
  return value;
}

void FieldReader::numbers(double* out, int count, std::string_view what) {
  for (int i = 0; i < count; ++i) out[i] = number(what);
}

std::int64_t FieldReader::integer_from_text(std::string_view what) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  const bool read = is_all_of(text, [&](const char* begin, const char* end) {
    const auto result = std::from_chars(begin, end, value);
    return std::pair(result.ptr, result.ec);
  });
  if (!read) fail_at(position_ - text.size(), fmt::format("{} (an integer)", what), text);
  return value;
}

bool FieldReader::accept(std::string_view text) {
  require_text();
  if (at_end()) return false;
  const std::size_t begin = position_;
  if (word("a field") == text) return true;
  position_ = begin;
  return false;
}

void FieldReader::expect_end() {
  if (at_end()) return;
  require_text();
  const std::size_t begin = position_;
  fail_at(begin, "the end of the line", word("a field"));
}

void FieldWriter::separate() {
  if (!out_->empty() && out_->back() != '\n') out_->push_back(' ');
}

void FieldWriter::word(std::string_view text) {
  separate();
  out_->append(text);
}

void FieldWriter::number(double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  word({text, static_cast<std::size_t>(result.ptr - text)});
}

void FieldWriter::integer(std::int64_t value) {
  char text[24];
  const auto result = std::to_chars(text, text + sizeof text, value);
  word({text, static_cast<std::size_t>(result.ptr - text)});
}

}  // namespace boxplus
