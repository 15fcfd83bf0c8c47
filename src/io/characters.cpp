// SPDX-License-Identifier: BSD-3-Clause
#include "io/characters.h"

#include "io/printable.h"

namespace boxplus {
namespace {

/// The longest prefix of at most `size` bytes that does not cut a UTF-8 character.
std::string_view beginning(std::string_view text, std::size_t size) {
  if (text.size() <= size) return text;
  while (size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  return text.substr(0, size);
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  if (text.empty()) return "the end of the line";
  const std::string_view shown = beginning(text, kLongest);
  std::string result = "'";
  for (std::size_t i = 0; i < shown.size();) {
    if (const std::size_t length = printable_length(shown, i); length > 0) {
      result += shown.substr(i, length);
      i += length;
    } else {
      result += hexadecimal_escape(shown[i++]);
    }
  }
  return result + (shown.size() < text.size() ? "…'" : "'");
}

}  // namespace boxplus
