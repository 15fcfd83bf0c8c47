// SPDX-License-Identifier: BSD-3-Clause
// Appends values to a JSON text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace boxplus {

/// Appends a string in quotes. `text` must be UTF-8.
void append_json_string(std::string_view text, std::string& out);
/// Appends a member: "text" with a string, or "bytes" with numbers if the text is not UTF-8.
void append_json_text(std::string_view text, std::string& out);
/// Appends the fields of a line, which are separated by one blank each, as items of an array: numbers, or
/// strings for words. Throws InvalidArgument for numbers that are not finite, and for words that JsonFields
/// cannot read.
void append_json_fields(std::string_view fields, std::string& out);
/// The number of bytes of `fields` before the last `count` fields.
std::size_t last_fields(std::string_view fields, int count);

}  // namespace boxplus
