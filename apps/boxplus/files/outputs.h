// SPDX-License-Identifier: BSD-3-Clause
// The outputs of a sub-command: files, or standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace boxplus::app {

struct Output {
  const char* option;  ///< the option that names it, for messages
  std::string path;    ///< "-": standard output; empty: none
};

/// Call before any work: throws InvalidArgument if two outputs are the same, and FileError if an output
/// cannot be written.
void check_outputs(const std::vector<Output>& outputs);

/// Call before any work: throws InvalidArgument if the output would replace one of the inputs, because an
/// output is never the same kind of file as an input.
void refuse_to_replace(const Output& output, const std::vector<std::string>& inputs);

/// "<stdout>" for "-", else the path.
std::string output_name(const std::string& path);

/// True if one of the outputs is standard output, which then must contain nothing else.
bool takes_stdout(const std::vector<Output>& outputs);

/// Writes a summary for the user: to stdout, or to stderr if stdout holds one of the outputs. Throws
/// FileError if stdout cannot be written.
void print_summary(const std::vector<Output>& outputs, std::string_view text);

/// Replaces a file completely or not at all, or writes to standard output. Throws FileError.
void write_output(const std::string& path, std::string_view text);

}  // namespace boxplus::app
