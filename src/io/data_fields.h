// SPDX-License-Identifier: BSD-3-Clause
// Fields that the lines of data (io/data.h) have in common.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/io/field_reader.h"

namespace boxplus {

/// Reads a number of items, which must not be negative.
std::int64_t read_count(FieldReader& in, std::string_view what);
/// Reads a number of values, and then the values.
std::vector<double> read_list(FieldReader& in, std::string_view count, std::string_view value);
void write_list(FieldWriter& out, std::span<const double> values);

/// Throws InvalidArgument if a value is not finite.
void write_finite(FieldWriter& out, std::span<const double> values);
/// Throws InvalidArgument if the text is empty or has blanks.
void write_word(FieldWriter& out, std::string_view what, const std::string& word);

}  // namespace boxplus
