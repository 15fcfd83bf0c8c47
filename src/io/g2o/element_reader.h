// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "io/g2o/vertex_ids.h"

namespace boxplus {

/// Adds single lines to a graph. Each function reads a line from after its tag on. It throws InputError if
/// the line is wrong, and then changes nothing.
class ElementReader {
 public:
  /// Both must outlive this object.
  ElementReader(Graph& graph, const UnknownTags& unknown) : graph_(graph), ids_(graph, unknown) {}

  /// Reads a vertex or a parameter. Returns its id.
  Id read_vertex(const Tag& tag, FieldReader& in);

  struct Edge {
    VertexIds::Result vertices;
    EdgeRef added = {};  ///< if all vertices are known
  };
  Edge read_edge(const Tag& tag, FieldReader& in);

  /// Returns false if a vertex has not been read yet.
  bool fix(FieldReader& in);

  /// See VertexIds.
  void end_of_vertices(bool create) { ids_.end_of_vertices(create); }
  std::int64_t created_vertices() const { return ids_.created(); }

 private:
  Graph& graph_;
  VertexIds ids_;
};

}  // namespace boxplus
