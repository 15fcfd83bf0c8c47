// SPDX-License-Identifier: BSD-3-Clause
// Text letter by letter, for canvases that place letters themselves.
#pragma once

#include <string_view>
#include <vector>

namespace boxplus::app {

struct Letter {
  char32_t code = 0;
  bool is_raised = false;  ///< the digit of an exponent: smaller, and above the others
};

/// The scale of raised letters, and their height above the baseline, relative to the text size.
inline constexpr double kRaisedSize = 0.66, kRaisedBy = 0.36;

/// Splits UTF-8 into letters; superscript digits become raised ones. Bytes that are not UTF-8 become U+FFFD.
std::vector<Letter> letters_of(std::string_view text);

}  // namespace boxplus::app
