// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes the graphs of the sub-commands: files, or standard input and output.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"

namespace CLI {
class App;
}

namespace boxplus::app {

/// The path that means standard input or output.
inline constexpr const char* kStandardStream = "-";

/// "<stdin>" for "-", else the path.
std::string input_name(const std::string& path);

/// All bytes of a file or of standard input. Throws FileError.
std::string read_text(const std::string& path);

/// Adds --lenient and --rename, which fill `options`.
void add_reading_options(CLI::App& command, ReadOptions& options);

/// Reads a graph. Throws FileError, and InputError if the file has neither a vertex nor an edge.
GraphFile read_input(const std::string& path, const ReadOptions& options = {});
/// The same from the text of the file.
GraphFile parse_input(const std::string& text, const std::string& path, const ReadOptions& options);

/// Reads a graph, prints the notes about its file, and computes estimates if the file has edges only.
GraphFile load_graph(const std::string& path, const ReadOptions& options = {});
/// Prints one message per note, up to a limit.
void print_notes(const GraphFile& file, const std::string& path);

/// Writes a .g2o file, or to standard output. Throws FileError.
void save_graph(const std::string& path, const GraphFile& file);

}  // namespace boxplus::app
