// SPDX-License-Identifier: BSD-3-Clause
// Messages of the command to the user, as opposed to its results.
#pragma once

#include <string>
#include <string_view>

namespace boxplus::app {

/// `text` as one line that cannot harm a terminal: control characters and bytes that are not UTF-8 become \n,
/// \t or \xNN.
std::string escaped(std::string_view text);

/// Writes text to stderr unchanged. If that fails (a closed stderr, a full disk), the text is lost and the
/// command continues, because there is no place left to report the failure.
void write_to_stderr(std::string_view text) noexcept;

/// Writes "boxplus: TEXT" to stderr, escaped, on a line of its own.
void print_message(std::string_view text);

}  // namespace boxplus::app
