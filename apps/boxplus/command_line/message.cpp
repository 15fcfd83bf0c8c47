// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/message.h"

#include <fmt/format.h>

#include <cstdio>

namespace boxplus::app {
namespace {

std::uint8_t byte_at(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
}

bool is_continuation(std::uint8_t byte) {
  return (byte & 0xC0) == 0x80;
}

/// The number of bytes of the printable character at `i`, or 0: control characters (C0, DEL, C1), overlong
/// forms, surrogates and stray bytes are not printable (RFC 3629, section 4).
std::size_t printable_length(std::string_view text, std::size_t i) {
  const std::uint8_t first = byte_at(text, i), second = byte_at(text, i + 1);
  if (first < 0x80) return first >= 0x20 && first != 0x7F ? 1 : 0;
  if (first < 0xC2 || first > 0xF4 || !is_continuation(second)) return 0;
  if (first < 0xE0) return first == 0xC2 && second < 0xA0 ? 0 : 2;
  if (!is_continuation(byte_at(text, i + 2))) return 0;
  if (first < 0xF0) return (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ? 0 : 3;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
  return is_continuation(byte_at(text, i + 3)) ? 4 : 0;
}

std::string escape_of(char c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  return fmt::format("\\x{:02x}", static_cast<std::uint8_t>(c));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t length = printable_length(text, i); length > 0) {
      result += text.substr(i, length);
      i += length;
    } else {
      result += escape_of(text[i++]);
    }
  }
  return result;
}

void write_to_stderr(std::string_view text) noexcept {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void print_message(std::string_view text) {
  write_to_stderr(fmt::format("boxplus: {}\n", escaped(text)));
}

}  // namespace boxplus::app
