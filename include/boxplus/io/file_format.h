// SPDX-License-Identifier: BSD-3-Clause
// File formats of graphs. A format has a name, an extension and three functions. read_graph(), write_graph()
// and the `boxplus` command find formats in a table. To add a custom format:
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
#include "boxplus/io/text_source.h"

namespace boxplus {

/// Receives text piece by piece.
using TextSink = detail::FunctionRef<void(std::string_view)>;

/// The graph that a format writes. If it was not read from a file, `edges` and `kept` are empty.
struct GraphFileView {
  const Graph& graph;
  /// The edges in the order of the file. New edges may be missing, and removed edges may be listed.
  std::span<const EdgeRef> edges = {};
  std::span<const GraphFile::KeptLine> kept = {};
};

struct FileFormat {
  std::string name;       ///< in messages: "TORO"
  std::string extension;  ///< of file names: ".graph"
  /// Says whether a file is in this format. `beginning` is the first block of its text (TextSource): whole
  /// lines, at least 128 KiB unless the text is shorter.
  std::function<bool(std::string_view beginning)> recognize;
  /// Throws InputError if the text is invalid. Ignores options that do not apply to the format.
  std::function<GraphFile(const TextSource& text, const ReadOptions& options)> read;
  /// Throws InvalidArgument if the format cannot represent the graph. Without this function, the format is
  /// read-only.
  std::function<void(const GraphFileView& file, const WriteOptions& options, TextSink sink)> write = {};

  /// For help texts: "TORO's .graph", or only ".g2o" if the extension equals the name.
  std::string label() const;
};

/// A table of formats.
class FileFormats {
 public:
  /// Throws InvalidArgument if the name or the extension is empty or taken, or if recognize or read is
  /// missing.
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

 private:
  std::vector<FileFormat> formats_;
};

/// .g2o, TORO and BAL.
const FileFormats& default_formats();

}  // namespace boxplus
