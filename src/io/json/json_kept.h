// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/io/graph_file.h"
#include "io/g2o/line_block.h"
#include "io/g2o/unknown_tags.h"
#include "io/json/json_scanner.h"

namespace boxplus {

/// A kept line, as it is in a JSON text.
struct JsonKeptLine {
  GraphFile::KeptLine line;
  const char* at = nullptr;

  /// Throws JsonError.
  void read(JsonScanner& in);
};

/// Adds kept lines to a file whose vertices and edges are complete.
class JsonKept {
 public:
  /// Both must outlive this object.
  JsonKept(GraphFile& file, const TagLookup& tags) : file_(file), tags_(tags) {}

  /// Call this if an edge of the text was skipped after `position` edges, because the positions of kept lines
  /// count this edge.
  void skip_edge(std::int64_t position) { skipped_.push_back(position); }
  /// Throws JsonError if the line would be part of the graph in a .g2o file, or if it follows no element of
  /// the graph.
  void add(const JsonKeptLine& kept, std::int64_t line_number);
  /// Call this after the last line.
  void add_notes();

 private:
  void check_text(const JsonKeptLine& kept, std::int64_t line_number);
  void check_unassigned(const JsonKeptLine& kept, const Tag& tag) const;

  GraphFile& file_;
  const TagLookup& tags_;
  UnknownTags unknown_;
  std::vector<std::int64_t> skipped_;
  std::int64_t unassigned_ = 0;
};

}  // namespace boxplus
