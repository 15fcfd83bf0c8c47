// SPDX-License-Identifier: BSD-3-Clause
// File formats of graphs. A format is three functions; a table of formats is all that read_graph(),
// write_graph() and the `boxplus` command know of them. Your own format:
//
//     FileFormats formats = default_formats();
//     formats.add({.name = "mine", .ending = ".mine", .recognize = …, .read = …, .write = …});
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

/// Takes a text piece by piece.
using TextSink = FunctionRef<void(std::string_view)>;

/// The graph that a format writes. A graph that was not read from a file has no lists.
struct GraphFileView {
  const Graph& graph;
  std::span<const EdgeRef> edges = {};  ///< in the order of the file; some may be gone since, others new
  std::span<const KeptLine> kept = {};
};

struct FileFormat {
  std::string name;    ///< for messages: "TORO"
  std::string ending;  ///< of the names of its files: ".graph"
  /// Whether a text is in this format. `beginning` is its first block (TextSource): whole lines, at least
  /// 128 KiB unless the text is shorter.
  std::function<bool(std::string_view beginning)> recognize;
  /// Throws InputError if the text is wrong. Options that make no sense for the format are ignored.
  std::function<GraphFile(const TextSource& text, const ReadOptions& options)> read;
  /// Without this function, files of the format are only read. Throws InvalidArgument if the format cannot
  /// hold the graph.
  std::function<void(const GraphFileView& file, const WriteOptions& options, TextSink sink)> write = {};

  /// For help texts: "TORO's .graph"; ".g2o" if the ending tells the name.
  std::string label() const;
};

/// A table of formats.
class FileFormats {
 public:
  /// Throws InvalidArgument if the name or the ending is empty or taken, or if the format cannot recognize
  /// or read.
  void add(FileFormat format);
  /// In the order in which they were added.
  std::span<const FileFormat> all() const { return formats_; }
  /// By name; nullptr if there is none.
  const FileFormat* find(std::string_view name) const;
  /// By the ending of a path; nullptr if no format has it.
  const FileFormat* of_path(std::string_view path) const;
  /// The format that recognizes a text by its beginning, or nullptr. The format that was added last is asked
  /// first: .g2o, which takes any text, is asked after all others.
  const FileFormat* recognize(std::string_view beginning) const;

 private:
  std::vector<FileFormat> formats_;
};

/// .g2o and TORO.
const FileFormats& default_formats();

}  // namespace boxplus
