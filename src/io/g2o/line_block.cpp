// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/line_block.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "io/characters.h"
#include "io/decimal.h"

namespace boxplus {
namespace {

bool ends_field(const char* at, const char* end) {
  return at == end || is_blank(*at);
}

/// The integer that makes up the whole field at `at`. If the field is anything else, or has more digits than
/// a double can hold exactly, the result has no `end`.
Decimal read_integer(const char* at, const char* end) {
  constexpr std::ptrdiff_t kMostDigits = 15;
  const bool negative = *at == '-';
  const char* const digits = at + negative;
  const char* digit = digits;
  std::int64_t value = 0;
  for (; digit != end && *digit >= '0' && *digit <= '9' && digit - digits < kMostDigits; ++digit) {
    value = 10 * value + (*digit - '0');
  }
  if (digit == digits || !ends_field(digit, end)) return {};
  return {negative ? -static_cast<double>(value) : static_cast<double>(value), digit, true};
}

/// The finite number that makes up the whole field at `at`. If the field is anything else, the result has no
/// `end`.
Decimal read_any_number(const char* at, const char* end) {
  if (const Decimal integer = read_integer(at, end); integer.end) return integer;
  Decimal number;
  const auto [stopped, error] = fast_float::from_chars(at, end, number.value);
  if (error == std::errc() && ends_field(stopped, end) && std::isfinite(number.value)) number.end = stopped;
  return number;
}

const char* skip_blanks(const char* at, const char* end) {
  while (at != end && is_blank(*at)) ++at;
  return at;
}

}  // namespace

void LineBlock::read(const TextSource& source, std::size_t k, const TagLookup& tags) {
  std::string_view text = source.block(k, memory_);
  lines_.clear();
  line_count_ = 0;
  last_name_ = {};
  values_.clear();
  text_end_ = text.data() + text.size();
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    const std::string_view line = text.substr(0, newline);
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    ++line_count_;
    read_line(line, tags);
  }
  place_fields();
}

/// Sets the pointers from the lines to their values. values_ must not grow after this.
void LineBlock::place_fields() {
  const double* next = values_.data();
  for (Line& line : lines_) {
    line.fields.values = {next, line.value_count};
    next += line.value_count;
  }
}

void LineBlock::read_line(std::string_view text, const TagLookup& tags) {
  // Some editors write this mark at the beginning of a file. In a concatenation of files, it may also begin
  // other lines.
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  while (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  const char* const end = text.data() + text.size();
  const char* const begin = skip_blanks(text.data(), end);
  if (begin == end) return;
  Line line;
  line.text = text;
  line.number = line_count_;
  const std::string_view name(begin, static_cast<std::size_t>(std::find_if(begin, end, is_blank) - begin));
  if (name[0] == '#') {
    line.kind = Line::Kind::kComment;
  } else if (name == "FIX") {
    line.kind = Line::Kind::kFix;
  } else {
    if (name != last_name_) {
      last_name_ = name;
      last_tag_ = tags.find(name);
    }
    line.tag = last_tag_;
    line.kind = line.tag ? Line::Kind::kElement : Line::Kind::kUnknown;
    const std::size_t values_before = values_.size();
    line.is_numeric = line.tag && read_fields(begin + name.size(), end, line.fields.integers);
    if (!line.is_numeric) values_.resize(values_before);
    line.value_count = values_.size() - values_before;
  }
  lines_.push_back(line);
}

/// Appends the fields to values_. Returns false if a field is not a number, or if there are so many fields
/// that they would take too much memory.
bool LineBlock::read_fields(const char* at, const char* end, std::size_t& integers) {
  constexpr std::size_t kMost = std::size_t{1} << 16;
  bool integers_only = true;
  std::size_t count = 0;
  for (at = skip_blanks(at, end); at != end && *at != '#'; at = skip_blanks(at, end)) {
    Decimal number;
    if (text_end_ - at >= kDecimalRoom) number = read_decimal(at);
    if (!number.end || !ends_field(number.end, end)) number = read_any_number(at, end);
    if (!number.end || ++count > kMost) return false;
    integers_only = integers_only && number.is_integer;
    values_.push_back(number.value);
    integers += integers_only;
    at = number.end;
  }
  return true;
}

}  // namespace boxplus
