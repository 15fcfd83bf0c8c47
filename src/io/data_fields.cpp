// SPDX-License-Identifier: BSD-3-Clause
#include "io/data_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxplus/base/error.h"
#include "io/characters.h"

namespace boxplus {

std::int64_t read_count(FieldReader& in, std::string_view what) {
  const FieldPlace place = in.place();
  const std::int64_t count = in.integer(what);
  if (count < 0) in.fail(place, fmt::format("expected {} (a number ≥ 0), got {}", what, count));
  return count;
}

std::vector<double> read_list(FieldReader& in, std::string_view count, std::string_view value) {
  constexpr std::int64_t kUsual = 4096;  // a larger count is believed only while the line has more fields
  const std::int64_t size = read_count(in, count);
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(std::min(size, kUsual)));
  for (std::int64_t i = 0; i < size; ++i) values.push_back(in.number(value));
  return values;
}

void write_list(FieldWriter& out, std::span<const double> values) {
  out.integer(static_cast<std::int64_t>(values.size()));
  write_finite(out, values);
}

void write_finite(FieldWriter& out, std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value))
      throw InvalidArgument(fmt::format("data: expected finite numbers, got {}", value));
    out.number(value);
  }
}

void write_word(FieldWriter& out, std::string_view what, const std::string& word) {
  const auto separates = [](char c) { return is_blank(c) || c == '\n'; };
  if (word.empty() || std::any_of(word.begin(), word.end(), separates)) {
    throw InvalidArgument(
        fmt::format("data: expected {} without blanks, got {}", what, word.empty() ? "''" : in_quotes(word)));
  }
  out.token(word);
}

}  // namespace boxplus
