// SPDX-License-Identifier: BSD-3-Clause
// Reading and writing graphs, in any of the formats of a FileFormats: .g2o, TORO's .graph, Gm2dl, logs of
// CARMEN and iSAM (these four are only read), and the problems of bundle adjustment (types/ba.h) of BAL and
// COLMAP. A COLMAP model is a folder. JSON holds any graph completely. Poses, points and edges are also
// written for viewers: PLY, VRML and gnuplot. docs/formats.md describes all formats.
//
// The first three have one element per line: a tag (see Registry), ids and values, separated by blanks. `#`
// begins a comment, and `FIX id…` fixes vertices. Elements may come in any order. Positions are in meters,
// angles in radians, and Ω is listed as its upper triangle by rows.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"

namespace boxplus {

class FileFormats;
class Registry;
namespace detail {
struct SparseModel;
}

struct ReadOptions {
  /// What to do with an edge whose Ω has a negative eigenvalue.
  enum class Indefinite : std::uint8_t {
    kRefuse,   ///< throw InputError
    kProject,  ///< replace Ω by the nearest positive semi-definite matrix, and count the edge
    /// Keep Ω (Information::as_given()), and count the edge. A large error of the edge may lower chi2.
    kAsGiven
  };
  const Registry* registry = nullptr;  ///< nullptr: default_registry()
  /// Tags to read as other tags: {"VERTEX_CAM", "VERTEX_SE3:QUAT"} reads VERTEX_CAM as VERTEX_SE3:QUAT.
  std::map<std::string, std::string, std::less<>> renames = {};
  bool lenient = false;  ///< skip, note and count lines that cannot be read, instead of throwing
  Indefinite indefinite = Indefinite::kRefuse;
  int threads = 0;  ///< maximum number; 0: one per hardware thread. It does not affect the graph.
  const FileFormats* formats = nullptr;  ///< nullptr: default_formats()
};

struct WriteOptions {
  const Registry* registry = nullptr;    ///< nullptr: default_registry()
  const FileFormats* formats = nullptr;  ///< nullptr: default_formats()
  /// The name of a format. If it is empty, the extension of the file selects the format. If no writable
  /// format has this extension, a graph that was read from a file is written in the format of that file
  /// (TORO and Gm2dl are only written if their name or extension is given).
  /// Otherwise the first format (.g2o) is used. If the path is that of a folder (one that exists, or a name
  /// with / at its end), only formats of folders are considered; the first one is COLMAP.
  std::string format = {};
};

/// A graph, and the parts of its file that a Graph does not contain.
struct GraphFile {
  /// A line that is not in the graph: a comment, a line of data (io/data.h), a line with an unknown tag, or
  /// an edge whose vertex has the id −1. Writing puts the line back after the element that it followed.
  struct KeptLine {
    enum class Place : std::uint8_t { kBegin, kAfterVertex, kAfterEdge };
    Place place = Place::kBegin;
    std::int64_t after = 0;  ///< a vertex id, or a position in GraphFile::edges (−1: before all edges)
    std::string text;
    std::int64_t line = 0;  ///< its number in the file, for messages; 0 if it was not read from a file
  };

  struct Note {
    std::int64_t line = 0;  ///< 0 if the note is about the whole file
    std::string text;
    std::int64_t column = 0;  ///< 0 if the note is about the whole line
    bool skipped = false;     ///< the line was skipped (lenient reading); `text` is the reason
  };
  Graph graph;
  std::vector<EdgeRef> edges = {};  ///< in the order of the file
  std::vector<KeptLine> kept = {};
  /// The model as it was read from COLMAP's files (io/sparse_model.h): names, colors and all that the graph
  /// does not contain. nullptr for other formats.
  std::shared_ptr<const detail::SparseModel> model = {};
  std::vector<Note> notes = {};  ///< unusual things that are not errors
  std::string format = {};       ///< the name of the file's format (FileFormat); read_graph() sets it
  std::int64_t lines = 0;        ///< number of lines of the file
  std::int64_t skipped = 0;      ///< number of skipped lines (lenient reading)
  std::int64_t indefinite = 0;   ///< number of edges whose Ω was indefinite, and was replaced or kept
  bool vertices_created =
      false;  ///< the file lists only edges, so the estimates are defaults: make an initial guess
};

/// Reads a file in the format that recognizes its beginning; the file's name does not matter. A folder is
/// read in the format that recognizes its files. Throws FileError if a file cannot be opened. Throws
/// InputError ("file:line:column: expected …, got …") for truncated lines, fields that are not finite
/// numbers, ids that are taken or unknown, vertices of the wrong type, indefinite Ω, and quaternions that are
/// far from unit length. Unknown tags are not errors: their lines are kept and noted.
GraphFile read_graph(const std::string& path, const ReadOptions& options = {});
/// Does the same as read_graph() for a text in memory. Messages use `name` as the name of the file.
GraphFile parse_graph(std::string_view text, const std::string& name, const ReadOptions& options = {});

/// Writes a file. A .g2o file lists parameters by id, then vertices by id, each followed by its FIX line,
/// then edges in the order of the file, then edges that were added later, by type. Every number is the
/// shortest text from which the same double is read. The file is replaced atomically. A folder is
/// created if necessary, and its files are replaced together: if this fails, all old files are put back.
/// Throws FileError if the file cannot be written, and InvalidArgument if the format cannot represent the
/// graph (a .g2o file: if an element has no tag), is unknown or read-only.
void write_graph(const std::string& path, const GraphFile& file, const WriteOptions& options = {});
void write_graph(const std::string& path, const Graph& graph, const WriteOptions& options = {});
/// The text that write_graph() would write to a file without an extension. Throws InvalidArgument if the
/// format is that of a folder.
std::string format_graph(const GraphFile& file, const WriteOptions& options = {});
std::string format_graph(const Graph& graph, const WriteOptions& options = {});

}  // namespace boxplus
