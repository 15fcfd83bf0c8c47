// SPDX-License-Identifier: BSD-3-Clause
// Makes text from files and arguments harmless to terminals. Everything is inline, because
// programs also use it, and the library does not export functions of private headers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace boxplus {

/// The number of bytes of the character at `i`, or 0 if it is not printable. Control characters (C0, DEL,
/// C1), overlong forms, surrogates and stray bytes are not printable (RFC 3629, section 4).
inline std::size_t printable_length(std::string_view text, std::size_t i) {
  const auto byte_at = [text](std::size_t k) {
    return k < text.size() ? static_cast<std::uint8_t>(text[k]) : std::uint8_t{0};
  };
  const auto is_continuation = [](std::uint8_t byte) { return (byte & 0xC0) == 0x80; };
  const std::uint8_t first = byte_at(i), second = byte_at(i + 1);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first < 0xC2 || first > 0xF4 || !is_continuation(second)) return 0;
  if (first < 0xE0) return first == 0xC2 && second < 0xA0 ? 0 : 2;
  if (!is_continuation(byte_at(i + 2))) return 0;
  if (first < 0xF0) return (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ? 0 : 3;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return is_continuation(byte_at(i + 3)) ? 4 : 0;
}

/// The escape sequence \xNN for a byte.
inline std::string hexadecimal_escape(char c) {
  constexpr const char* kDigits = "0123456789abcdef";
  const auto code = static_cast<std::uint8_t>(c);
  return {'\\', 'x', kDigits[code >> 4], kDigits[code & 15]};
}

/// `text` as one line that does no harm to a terminal: control characters and bytes that are not UTF-8 become
/// \n, \t or \xNN.
inline std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t length = printable_length(text, i); length > 0) {
      result += text.substr(i, length);
      i += length;
    } else {
      const char c = text[i++];
      result += c == '\n' ? "\\n" : c == '\t' ? "\\t" : hexadecimal_escape(c);
    }
  }
  return result;
}

}  // namespace boxplus
