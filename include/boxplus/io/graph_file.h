// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing graphs: .g2o, and TORO's .graph (reading only).
//
// One element per line: a word (see Registry), ids, numbers separated by blanks. `#` begins a comment, `FIX
// id…` fixes vertices. Elements may come in any order. Positions are metres, angles radians, Ω the upper
// triangle by rows.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

class Registry;

struct ReadOptions {
  const Registry* registry = nullptr;  ///< nullptr: default_registry()
  /// Words to take for others: {"VERTEX_CAM", "VERTEX_SE3:QUAT"} reads the first as the second.
  std::map<std::string, std::string, std::less<>> renames = {};
  bool lenient = false;  ///< skip, note and count lines that cannot be read, instead of throwing
  int threads = 0;       ///< at most; 0: one per hardware thread. What is read does not depend on it.
};

/// A line that is no element (a comment, an unknown word, an edge with an unassigned vertex), kept for
/// writing back after the element that it followed.
struct KeptLine {
  enum class Place : std::uint8_t { kBegin, kAfterVertex, kAfterEdge };
  Place place = Place::kBegin;
  std::int64_t after = 0;  ///< the id of the vertex; the position in GraphFile::edges, or −1: before them
  std::string text;
};

/// A graph, and what its file says beyond it.
struct GraphFile {
  struct Note {
    std::int64_t line = 0;  ///< 0: the file as a whole
    std::string text;
    std::int64_t column = 0;  ///< 0: the line as a whole
    bool skipped = false;     ///< the line was skipped (lenient reading): `text` tells what is wrong with it
  };
  Graph graph;
  std::vector<EdgeRef> edges = {};  ///< in the order of the file
  std::vector<KeptLine> kept = {};
  std::vector<Note> notes = {};  ///< what was odd, but no error
  std::int64_t lines = 0;        ///< of the file
  std::int64_t skipped = 0;      ///< lines that were skipped (lenient reading)
  bool vertices_created =
      false;  ///< the file lists edges only: the estimates mean nothing, and need an initial guess
};

/// Reads a file. Throws FileError where it cannot be opened, and InputError ("file:line:column: what was
/// expected, what came") for truncated lines, what is no finite number, ids that are taken or unknown,
/// vertices of the wrong type, indefinite Ω, quaternions that are none. Unknown words never are an error:
/// their lines are kept and noted.
GraphFile read_graph(const std::string& path, const ReadOptions& options = {});
/// The same from memory; `name` stands for the file in messages.
GraphFile parse_graph(std::string_view text, const std::string& name, const ReadOptions& options = {});

/// Writes a .g2o file: parameters by id, vertices by id, each followed by its FIX line, edges in the order of
/// the file (those added since: by type). Every number is the shortest text that reads back to the same
/// double. The file is replaced at once, or not at all. Throws FileError where it cannot be written, and
/// InvalidArgument where an element has no word.
void write_graph(const std::string& path, const GraphFile& file, const Registry* registry = nullptr);
void write_graph(const std::string& path, const Graph& graph, const Registry* registry = nullptr);
/// The text that write_graph() writes.
std::string format_graph(const GraphFile& file, const Registry* registry = nullptr);

/// Replaces a file at once, or not at all. Throws FileError.
void write_file(const std::string& path, std::string_view text);
/// Throws the FileError that write_file() would throw for this path, as far as can be told without writing:
/// called before long work, so that it is not in vain.
void require_writable(const std::string& path);
/// Removes what these functions have written so far of files that are not finished. Only for handlers of
/// signals that end the process, which may call it at any time: such files have no name, and vanish by
/// themselves, where the file system can do so.
void remove_temporary_files() noexcept;

}  // namespace boxplus
