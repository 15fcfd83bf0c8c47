// SPDX-License-Identifier: BSD-3-Clause
// File formats of graphs. A format has a name, an extension and three functions, or a name and the functions
// of a folder. read_graph(), write_graph() and the `boxplus` command find formats in a table. To add a custom
// format:
//
//     FileFormats formats = default_formats();
//     formats.add({.name = "mine", .extension = ".mine", .recognize = …, .read = …, .write = …});
//     GraphFile file = read_graph(path, {.formats = &formats});
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/function_ref.h"
#include "boxplus/io/graph_file.h"
#include "boxplus/io/text_sink.h"
#include "boxplus/io/text_source.h"

namespace boxplus {

/// The graph that a format writes. If it was not read from a file, `edges` and `kept` are empty.
struct GraphFileView {
  const Graph& graph;
  /// The edges in the order of the file. New edges may be missing, and removed edges may be listed.
  std::span<const EdgeRef> edges = {};
  std::span<const GraphFile::KeptLine> kept = {};
  const detail::SparseModel* model = nullptr;  ///< of GraphFile::model
};

/// The functions of a format whose graphs are folders of several files.
struct FolderFunctions {
  /// Says whether a folder contains a graph in this format, even if some of its files are missing.
  std::function<bool(const std::string& folder)> recognize = {};
  /// Throws FileError if a file is missing, and InputError if a file is invalid.
  std::function<GraphFile(const std::string& folder, const ReadOptions& options)> read = {};
  /// Throws whatever write() would throw, as far as this can be checked without writing.
  std::function<void(const GraphFileView& file, const std::string& folder)> check = {};
  /// Creates the folder if necessary. Throws InvalidArgument if the format cannot represent the graph, and
  /// FileError if the folder cannot be written. Without this function, the format is read-only.
  std::function<void(const GraphFileView& file, const std::string& folder)> write = {};
};

struct FileFormat {
  std::string name;            ///< in messages: "TORO"
  std::string extension = {};  ///< of file names: ".graph"; empty if its graphs are folders
  /// Says whether a file is in this format. `beginning` is the first block of its text (TextSource): whole
  /// lines, at least 128 KiB unless the text is shorter.
  std::function<bool(std::string_view beginning)> recognize = {};
  /// Throws InputError if the text is invalid. Ignores options that do not apply to the format. Without this
  /// function, the format is write-only.
  std::function<GraphFile(const TextSource& text, const ReadOptions& options)> read = {};
  /// Throws InvalidArgument if the format cannot represent the graph. Without this function, the format is
  /// read-only.
  std::function<void(const GraphFileView& file, const WriteOptions& options, TextSink sink)> write = {};
  /// If they are given, the four functions above are not used.
  FolderFunctions folder = {};
  /// See losses() below. Without this function, writing leaves nothing out of which losses() must tell.
  std::function<std::vector<std::string>(const GraphFileView& file)> losses = {};
  /// Whether files keep the kernels, levels and fixed directions of a graph, and which edges are disabled.
  bool keeps_everything = false;

  /// Whether a graph is written in this format only if its name or its extension is given, because .g2o keeps
  /// more. Otherwise a graph that was read in a format is also written in it.
  bool written_on_request = false;

  bool is_folder() const { return static_cast<bool>(folder.recognize); }
  bool can_read() const { return read || folder.read; }
  bool can_write() const { return write || folder.write; }
  /// For help texts: "TORO's .graph", "COLMAP folder", or only ".g2o" if the extension equals the name.
  std::string label() const;
};

/// A table of formats.
class FileFormats {
 public:
  /// Throws InvalidArgument if the name or the extension is taken, or if a part is missing: the name; the
  /// extension, recognize, and read or write; or for a folder, recognize and read.
  void add(FileFormat format);
  /// All formats in the order in which they were added.
  std::span<const FileFormat> all() const { return formats_; }
  /// The format with this name; nullptr if there is none.
  const FileFormat* find(std::string_view name) const;
  /// The format with the extension of this path; nullptr if there is none.
  const FileFormat* of_path(std::string_view path) const;
  /// The format that recognizes the beginning of a file, or nullptr. The format that was added last is tried
  /// first. Therefore, .g2o, which accepts any text, is tried after all other formats.
  const FileFormat* recognize(std::string_view beginning) const;
  /// The format of a folder, or nullptr. The format that was added last is tried first.
  const FileFormat* recognize_folder(const std::string& folder) const;

 private:
  std::vector<FileFormat> formats_;
};

/// .g2o, TORO, Gm2dl, CARMEN, iSAM, BAL, COLMAP (binary and text), JSON, gnuplot, VRML and PLY.
const FileFormats& default_formats();

/// What write_graph() leaves out because the format cannot keep it, although the written problem is the same
/// otherwise: one sentence for each kind, such as "the information of 3 edges". Empty if nothing is left out.
/// Throws InvalidArgument if the format is unknown or read-only.
std::vector<std::string> losses(const std::string& path, const GraphFile& file,
                                const WriteOptions& options = {});

/// Throws the InvalidArgument or FileError that write_graph() would throw, as far as this can be checked
/// without writing. Call it before a long computation, so that its result can be saved.
void require_writable(const std::string& path, const GraphFile& file, const WriteOptions& options = {});

}  // namespace boxplus
