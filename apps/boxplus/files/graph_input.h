// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes graphs for the sub-commands, from and to files or standard input and output.
#pragma once

#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"

namespace CLI {
class App;
}

namespace boxplus::app {

/// Returns "<stdin>" for "-", and otherwise the path.
std::string input_name(const std::string& path);

/// Reads a whole file or standard input. The text of a folder is empty. Throws FileError if this fails.
std::string read_text(const std::string& path);

/// Adds the options --lenient and --rename, which set `options`.
void add_reading_options(CLI::App& command, ReadOptions& options);

/// Reads a graph. If this takes a while, shows the progress, unless `quiet`. Throws FileError if the file
/// cannot be read. Throws InputError if the file is malformed, or if it has neither a vertex nor an edge.
GraphFile read_input(const std::string& path, const ReadOptions& options = {}, bool quiet = false);
/// Like read_input(), but parses `text`, which read_text() returned for this path. A folder is read from
/// `path`. Messages contain `path`.
GraphFile parse_input(const std::string& text, const std::string& path, const ReadOptions& options);

/// Reads a graph and prints the notes about the file. If the file has edges only, also computes initial
/// estimates.
GraphFile load_graph(const std::string& path, const ReadOptions& options = {}, bool quiet = false);
/// Prints one message per note. If there are many notes, prints only the first ones and the number of all
/// others.
void print_notes(const GraphFile& file, const std::string& path);
void print_notes(const std::vector<GraphFile::Note>& notes, const std::string& path);

/// Throws InvalidArgument or FileError if the graph cannot be written to `path` in the format that
/// save_graph() uses, as far as this can be checked without writing. Call it before a long computation.
void require_representable(const std::string& path, const GraphFile& file);
/// Writes a graph in the format with the given name (FileFormat) or, if it is empty, in the format of the
/// extension of `path`. Without such a format, and to standard output, writes the format of the file from
/// which the graph was read, or .g2o. If this takes a while, shows the progress, unless `quiet`. Throws
/// FileError if this fails.
void save_graph(const std::string& path, const GraphFile& file, const std::string& format = {},
                bool quiet = false);

}  // namespace boxplus::app
