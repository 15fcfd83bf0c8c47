// SPDX-License-Identifier: BSD-3-Clause
// Where results go: to files, or to the standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace boxplus::app {

struct Output {
  const char* option;  ///< that names it, for complaints
  std::string path;    ///< "-": the standard output; empty: none
};

/// Before any work: throws InvalidArgument where two outputs are the same, FileError where one cannot be
/// written.
void check_outputs(const std::vector<Output>& outputs);

/// Before any work: throws InvalidArgument where the output would replace an input, which it is not like.
void refuse_to_replace(const Output& output, const std::vector<std::string>& inputs);

/// "<stdout>" for "-", else the path.
std::string output_name(const std::string& path);

/// Whether one of them is the standard output, which then holds nothing else.
bool takes_stdout(const std::vector<Output>& outputs);

/// Writes a summary for people: to stdout, or to stderr if stdout holds one of the outputs. Throws FileError
/// if stdout cannot be written.
void print_summary(const std::vector<Output>& outputs, std::string_view text);

/// Replaces a file at once or not at all, or writes to the standard output. Throws FileError.
void write_output(const std::string& path, std::string_view text);

}  // namespace boxplus::app
