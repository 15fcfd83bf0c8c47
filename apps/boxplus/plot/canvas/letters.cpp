// SPDX-License-Identifier: BSD-3-Clause
#include "plot/canvas/letters.h"

#include <cstdint>

namespace boxplus::app {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

/// Removes the first code point from a non-empty text, and returns it.
char32_t take(std::string_view& text) {
  const auto byte = [&text](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xC2 ? 0
                             : first < 0xE0 ? 2
                             : first < 0xF0 ? 3
                             : first < 0xF5 ? 4
                                            : 0;
  char32_t code = length == 1 ? first : first & (0x7Fu >> length);
  bool is_valid = length > 0 && length <= text.size();
  for (std::size_t i = 1; is_valid && i < length; ++i) {
    is_valid = (byte(i) & 0xC0) == 0x80;
    code = (code << 6) | (byte(i) & 0x3Fu);
  }
  text.remove_prefix(is_valid ? length : 1);
  return is_valid ? code : kReplacement;
}

Letter letter(char32_t code) {
  constexpr char32_t kZero = 0x2070, kFour = 0x2074, kNine = 0x2079;
  if (code == 0xB9) return {'1', true};
  if (code == 0xB2 || code == 0xB3) return {U'2' + (code - 0xB2), true};
  if (code == kZero || (code >= kFour && code <= kNine)) return {U'0' + (code - kZero), true};
  return {code, false};
}

}  // namespace

std::vector<Letter> letters_of(std::string_view text) {
  std::vector<Letter> letters;
  while (!text.empty()) letters.push_back(letter(take(text)));
  return letters;
}

}  // namespace boxplus::app
