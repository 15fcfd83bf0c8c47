// SPDX-License-Identifier: BSD-3-Clause
// Splits text into letters, for canvases that place each letter themselves.
#pragma once

#include <string_view>
#include <vector>

namespace boxplus::app {

struct Letter {
  char32_t code = 0;
  bool is_raised = false;  ///< true for a digit of an exponent, which is smaller and higher
};

/// The size of raised letters and their height above the baseline, both relative to the text size.
inline constexpr double kRaisedSize = 0.66, kRaisedBy = 0.36;

/// Splits UTF-8 text into letters. Superscript digits become raised digits. Bytes that are not valid UTF-8
/// become U+FFFD.
std::vector<Letter> letters_of(std::string_view text);

}  // namespace boxplus::app
