// SPDX-License-Identifier: BSD-3-Clause
// Recognizes blanks in text files, and quotes parts of text files for messages.
#pragma once

#include <string>
#include <string_view>

namespace boxplus {

/// Whether c is a blank within a line. Any other control character is part of a field.
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Some editors write a mark at the beginning of a file.
inline std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  while (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

/// `text` in quotes, shortened if it is long. Control characters and bytes that are not UTF-8 become \xNN. If
/// `text` is empty, returns "the end of the line".
std::string in_quotes(std::string_view text);

}  // namespace boxplus
