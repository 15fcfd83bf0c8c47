// SPDX-License-Identifier: BSD-3-Clause
// Text as canvases that set it themselves need it: letter by letter.
#pragma once

#include <string_view>
#include <vector>

namespace boxplus::app {

struct Letter {
  char32_t code = 0;
  bool is_raised = false;  ///< the digit of an exponent: smaller, and above the others
};

/// What raised letters are multiplied by, and raised by, in units of the size of the text.
inline constexpr double kRaisedSize = 0.66, kRaisedBy = 0.36;

/// UTF-8, with superscript digits as raised ones. What is no UTF-8 becomes U+FFFD.
std::vector<Letter> letters_of(std::string_view text);

}  // namespace boxplus::app
