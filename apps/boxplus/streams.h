// SPDX-License-Identifier: BSD-3-Clause
// Files, or "-" for the standard input and output.
#pragma once

#include <string>
#include <string_view>

#include "boxplus/io/graph_file.h"

namespace boxplus::app {

inline constexpr std::string_view kStream = "-";

/// Throws FileError, also where there is no vertex, and InputError.
GraphFile read_graph_or_stdin(const std::string& path);

/// Before any work: throws FileError where this cannot be written.
void require_writable_or_stdout(const std::string& path);
void write_file_or_stdout(const std::string& path, std::string_view text);

}  // namespace boxplus::app
