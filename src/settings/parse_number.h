// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a user types.
#pragma once

#include <charconv>
#include <concepts>
#include <string>
#include <system_error>

#include "base/number_from_chars.h"

namespace boxplus {

/// Reads a number in the format of C, without blanks, whatever the locale. Returns false unless the whole
/// text is a number that T can hold.
template <class T>
bool parse_number(const std::string& text, T& value) {
  const char *begin = text.data(), *end = begin + text.size();
  std::from_chars_result read{};
  if constexpr (std::same_as<T, double>)
    read = number_from_chars(begin, end, value);
  else
    read = std::from_chars(begin, end, value);
  return read.ec == std::errc() && read.ptr == end;
}

}  // namespace boxplus
