// SPDX-License-Identifier: BSD-3-Clause
// Standard input, output and error of the process.
#pragma once

#include <cstddef>
#include <optional>

namespace boxplus {

/// Opens /dev/null for each standard stream that is closed. The mode is such that reading from stdin and
/// writing to stdout or stderr still fail. Without this function, the next file that the process opens could
/// become its standard error, and messages would be written into that file. Must be called before any file is
/// opened.
void reserve_standard_streams();

/// Waits until there is input, or its end or an error. Returns false after this time, or at a signal.
bool wait_for_stdin(int milliseconds);
/// Reads up to `size` bytes from stdin, and returns their number, which is 0 at its end. Returns nullopt and
/// sets errno if it fails; EINTR: a signal came first.
std::optional<std::size_t> read_stdin(char* out, std::size_t size);

bool stderr_is_terminal();
/// The number of columns of the terminal that is stderr, or 0 if it is unknown.
std::size_t stderr_columns();

}  // namespace boxplus
