// SPDX-License-Identifier: BSD-3-Clause
// What the command says to people, apart from its results.
#pragma once

#include <string>
#include <string_view>

namespace boxplus::app {

/// `text` as one line that does no harm to a terminal: control characters and bytes that are no UTF-8 become
/// \n, \t or \xNN.
std::string escaped(std::string_view text);

/// Writes text to stderr as it is. Nobody can be told if that fails (a closed stderr, a full disk): the text
/// is lost, and the command goes on.
void write_to_stderr(std::string_view text) noexcept;

/// Writes "boxplus: TEXT" to stderr, escaped, on a line of its own.
void print_message(std::string_view text);

}  // namespace boxplus::app
