// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "io/g2o/vertex_ids.h"

namespace boxplus {

/// Adds the contents of single lines to a graph. Each function reads the rest of a line, after its tag. If
/// the line is wrong, the function throws InputError and changes nothing.
class ElementReader {
 public:
  /// All arguments must outlive this object.
  ElementReader(Graph& graph, const UnknownTags& unknown, const Registry& registry)
      : graph_(graph), ids_(graph, unknown, registry) {}

  /// Reads a vertex or a parameter. Returns its id.
  Id read_vertex(const Tag& tag, FieldReader& in);

  struct Edge {
    VertexIds::Result vertices;
    EdgeRef added = {};  ///< the new edge; only if `vertices` is kKnown
  };
  Edge read_edge(const Tag& tag, FieldReader& in);

  /// Fixes the vertices that a FIX line lists. Returns false if one of these vertices has not been read yet.
  bool fix(FieldReader& in);

  /// See VertexIds::end_of_vertices() and VertexIds::created().
  void end_of_vertices(bool create) { ids_.end_of_vertices(create); }
  std::int64_t created_vertices() const { return ids_.created(); }

 private:
  Graph& graph_;
  VertexIds ids_;
};

}  // namespace boxplus
