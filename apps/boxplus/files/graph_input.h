// SPDX-License-Identifier: BSD-3-Clause
// Graphs as the sub-commands read them: from a file, or from the standard input.
#pragma once

#include <string>

#include "boxplus/io/graph_file.h"

namespace CLI {
class App;
}

namespace boxplus::app {

/// What stands for the standard input and output in place of a path.
inline constexpr const char* kStandardStream = "-";

/// "<stdin>" for "-", else the path.
std::string input_name(const std::string& path);

/// All bytes of a file or of the standard input. Throws FileError.
std::string read_text(const std::string& path);

/// Adds --lenient and --rename, which fill `options`.
void add_reading_options(CLI::App& command, ReadOptions& options);

/// Reads a graph. Throws FileError, and InputError also where the file holds no vertex and no edge.
GraphFile read_input(const std::string& path, const ReadOptions& options = {});
/// The same from the text of the file.
GraphFile parse_input(const std::string& text, const std::string& path, const ReadOptions& options);

/// Reads a graph, prints the notes of its file, and places the vertices of a file that has edges only.
GraphFile load_graph(const std::string& path, const ReadOptions& options = {});
/// One message per note, and not too many.
void print_notes(const GraphFile& file, const std::string& path);

/// Writes a .g2o file, or to the standard output. Throws FileError.
void save_graph(const std::string& path, const GraphFile& file);

}  // namespace boxplus::app
