// SPDX-License-Identifier: BSD-3-Clause
// The outputs of a sub-command: files or standard output.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace boxplus::app {

/// The path that stands for standard input or standard output.
inline constexpr const char* kStandardStream = "-";

struct Output {
  const char* option;  ///< the option that names the output, for messages
  std::string path;    ///< "-" means standard output; an empty path means no output
  bool may_be_folder = false;
};

/// The output for a graph that is read from `input`. It may be a folder if it names one, or if the input is
/// one.
Output graph_output(const char* option, const std::string& path, const std::string& input);

/// Must be called before any other work. Throws InvalidArgument if two outputs are the same file, and
/// FileError if an output cannot be written. Does not check outputs that may be folders, because
/// require_representable() checks them when the graph is known.
void check_outputs(const std::vector<Output>& outputs);

/// Must be called before any other work. Throws InvalidArgument if the output would replace one of the
/// inputs. This is always a mistake, because the output is a different kind of file than the inputs.
void refuse_to_replace(const Output& output, const std::vector<std::string>& inputs);

/// Returns "<stdout>" for "-", and otherwise the path.
std::string output_name(const std::string& path);

/// Returns true if one of the outputs is standard output. If so, nothing else may be written to it.
bool takes_stdout(const std::vector<Output>& outputs);

/// Writes a summary for the user to stdout, or to stderr if stdout is one of the outputs. Throws FileError if
/// stdout cannot be written.
void print_summary(const std::vector<Output>& outputs, std::string_view text);

/// Writes `text` to standard output or a file. A file is replaced either completely or not at all. Throws
/// FileError if writing fails.
void write_output(const std::string& path, std::string_view text);

}  // namespace boxplus::app
