// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "io/printable.h"

namespace boxplus {

/// The number of bytes of the UTF-8 character at `i`, or 0 if there is none (RFC 3629).
inline std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto first = static_cast<unsigned char>(text[i]);
  if (first < 0x80) return 1;
  const bool is_control = first == 0xC2 && i + 1 < text.size() &&
                          static_cast<unsigned char>(text[i + 1]) - 0x80u < 0x20u;  // U+0080 … U+009F
  return is_control ? 2 : printable_length(text, i);
}

inline bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

/// Appends a character, which must not be a surrogate.
inline void append_utf8(std::string& out, unsigned code) {
  const auto continuation = [&](int shift) { out += static_cast<char>(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xC0 | code >> 6);
    continuation(0);
  } else if (code < 0x10000) {
    out += static_cast<char>(0xE0 | code >> 12);
    continuation(6);
    continuation(0);
  } else {
    out += static_cast<char>(0xF0 | code >> 18);
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

}  // namespace boxplus
