// SPDX-License-Identifier: BSD-3-Clause
#include "files/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/write_file.h"
#include "command_line/message.h"

namespace boxplus::app {
namespace {

bool is_stdout(const Output& output) {
  return output.path == kStandardStream || output.path == "/dev/stdout";
}

/// Returns the absolute path with all symlinks resolved, or an empty path if it cannot be determined.
std::filesystem::path place_of(const std::string& path) {
  std::error_code none;
  return std::filesystem::weakly_canonical(std::filesystem::absolute(path, none), none);
}

bool are_same(const Output& a, const Output& b) {
  if (a.path.empty() || b.path.empty()) return false;
  if (is_stdout(a) || is_stdout(b)) return is_stdout(a) && is_stdout(b);
  std::error_code none;
  if (std::filesystem::is_character_file(a.path, none)) return false;  // several outputs may go to /dev/null
  if (std::filesystem::equivalent(a.path, b.path, none)) return true;  // also true for hard links
  const std::filesystem::path place = place_of(a.path);
  return !place.empty() && place == place_of(b.path);
}

void write_to_stdout(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw FileError("cannot write to standard output");
}

}  // namespace

Output graph_output(const char* option, const std::string& path, const std::string& input) {
  const auto is_folder = [](const std::string& name) {
    std::error_code none;
    return name.ends_with('/') || std::filesystem::is_directory(name, none);
  };
  return {option, path, is_folder(input) || is_folder(path)};
}

void check_outputs(const std::vector<Output>& outputs) {
  for (auto a = outputs.begin(); a != outputs.end(); ++a) {
    for (auto b = a + 1; b != outputs.end(); ++b) {
      if (are_same(*a, *b)) {
        throw InvalidArgument(fmt::format("{} and {}: expected two different files, got '{}' and '{}'",
                                          a->option, b->option, a->path, b->path));
      }
    }
  }
  for (const Output& output : outputs) {
    if (!output.path.empty() && !is_stdout(output) && !output.may_be_folder) require_writable(output.path);
  }
}

void refuse_to_replace(const Output& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (input != kStandardStream && are_same(output, {"", input})) {
      throw InvalidArgument(
          fmt::format("{}: expected a file other than the input '{}'", output.option, input));
    }
  }
}

std::string output_name(const std::string& path) {
  return path == kStandardStream ? "<stdout>" : path;
}

bool takes_stdout(const std::vector<Output>& outputs) {
  return std::any_of(outputs.begin(), outputs.end(), is_stdout);
}

void print_summary(const std::vector<Output>& outputs, std::string_view text) {
  if (takes_stdout(outputs)) return write_to_stderr(text);
  write_to_stdout(text);
}

void write_output(const std::string& path, std::string_view text) {
  if (path != kStandardStream) return write_file(path, text);
  write_to_stdout(text);
}

}  // namespace boxplus::app
