// SPDX-License-Identifier: BSD-3-Clause
// Prints messages of the command to stderr. (Its results go to stdout.)
#pragma once

#include <string>
#include <string_view>

namespace boxplus::app {

/// Returns `text` as one line that is safe to print on a terminal. Control characters and bytes that are not
/// valid UTF-8 become \n, \t or \xNN.
std::string escaped(std::string_view text);

/// Writes `text` to stderr unchanged. If this fails (because stderr is closed or the disk is full), the text
/// is lost and the command continues, because there is no place left to report the failure.
void write_to_stderr(std::string_view text) noexcept;

/// Escapes `text` and writes the line "boxplus: TEXT" to stderr.
void print_message(std::string_view text);

}  // namespace boxplus::app
