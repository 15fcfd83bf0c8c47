// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a user types.
#pragma once

#include <charconv>
#include <string>
#include <system_error>

namespace boxplus {

/// Reads a number in the format of C, without blanks, whatever the locale. Returns false unless the whole
/// text is a number that T can hold.
template <class T>
bool parse_number(const std::string& text, T& value) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

}  // namespace boxplus
