// SPDX-License-Identifier: BSD-3-Clause
// What the main functions of the programs share.
#pragma once

#include <string>
#include <string_view>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/graph_file.h"

namespace boxplus::programs {

/// The exit codes. A wrong argument has the code of a file that cannot be opened or written, as in `g2o`.
enum ExitCode : int { kSuccess = 0, kBadFile = 1, kBadInput = 2 };

/// Calls `body` and returns its exit code. If it throws, prints the message, and returns kBadInput for
/// malformed input, and otherwise kBadFile.
int run_program(const char* name, detail::FunctionRef<int()> body);

/// Writes to standard error, if possible.
void print_error(std::string_view line);
/// Writes "NAME: TEXT" and a line break to standard error. Control characters are escaped.
void print_message(std::string_view text);
/// Writes "# TEXT" and a line break to standard error.
void print_remark(std::string_view text);
/// Writes to standard output at once. Throws FileError if this fails.
void print_output(std::string_view text);

/// Reads a graph of any format, and prints the notes about it. "-" is standard input. Throws FileError and
/// InputError; a file without vertices and edges is an InputError, too.
GraphFile load_graph(const std::string& path);
/// Writes a graph in the format of the extension, or .g2o; "-" is standard output. Throws FileError.
void save_graph(const std::string& path, const GraphFile& file);
/// Throws the FileError that save_graph() would throw, as far as this can be checked without writing. Does
/// nothing for an empty path and for "-".
void require_output(const std::string& path);

}  // namespace boxplus::programs
