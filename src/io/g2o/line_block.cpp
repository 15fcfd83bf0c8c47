// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/line_block.h"

#include <algorithm>

#include "io/characters.h"
#include "io/decimal.h"
#include "io/number_field.h"

namespace boxplus {
namespace {

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
  text = without_byte_order_mark(text);  // in concatenated files, any line may have one
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
    if (!number.end || !ends_field(number.end, end)) number = read_number_field(at, end);
    if (!number.end || ++count > kMost) return false;
    integers_only = integers_only && number.is_integer;
    values_.push_back(number.value);
    integers += integers_only;
    at = number.end;
  }
  return true;
}

}  // namespace boxplus
