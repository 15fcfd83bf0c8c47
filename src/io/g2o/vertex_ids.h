// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "boxplus/graph/graph.h"
#include "boxplus/io/field_reader.h"
#include "boxplus/io/registry.h"
#include "boxplus/io/tag.h"
#include "io/g2o/unknown_tags.h"

namespace boxplus {

/// Reads the ids of vertices and parameters that a line refers to.
class VertexIds {
 public:
  /// All arguments must outlive this object. Messages name tags of the registry.
  VertexIds(Graph& graph, const UnknownTags& unknown, const Registry& registry)
      : graph_(graph), unknown_(unknown), registry_(registry) {}

  /// Call this after the last vertex has been read. From then on, an id that is not in the graph is an error.
  /// However, if `create` is true, reading an edge with such an id creates a vertex with that id.
  void end_of_vertices(bool create) {
    all_known_ = true;
    create_ = create;
  }
  std::int64_t created() const { return created_; }

  enum class Result : std::uint8_t { kKnown, kUnassigned, kNotYetKnown };
  /// Reads the ids of the vertices of an edge. The result says whether all vertices are known, one id is -1
  /// (no vertex), or one id belongs to a vertex that has not been read yet. In all other cases, throws
  /// InputError. Checks the rest of the line before it creates missing vertices.
  Result read_of_edge(const Tag& tag, FieldReader& in);
  /// Reads the ids of the vertices in a FIX line. Returns false if a vertex has not been read yet.
  bool read_to_end(FieldReader& in);

  /// If the last two ids of the last line name the same parameter, and `tag` has a variant with one shared
  /// parameter, drops one of the two and returns the variant. Otherwise returns `tag`.
  const Tag& merge_shared_parameter(const Tag& tag);
  const std::vector<VertexRef>& vertices() const { return vertices_; }
  /// Throws InputError if the last line refers to a vertex twice.
  void refuse_repetition(const FieldReader& in);

 private:
  /// A vertex of the current line that is to be created.
  struct Missing {
    std::size_t index;  // in vertices_
    Id id;
    VertexRef (*create)(Graph&, Id);
  };

  Result read_one(const Tag::Argument& argument, FieldReader& in);
  void create_missing(const Tag& tag, FieldReader in);
  [[noreturn]] void fail_unknown(FieldPlace place, Id id, bool is_parameter, const FieldReader& in,
                                 const std::string& remedy = {}) const;

  Graph& graph_;
  const UnknownTags& unknown_;
  const Registry& registry_;
  bool all_known_ = false, create_ = false;
  std::int64_t created_ = 0;
  std::vector<VertexRef> vertices_, sorted_;
  std::vector<Missing> missing_;
};

}  // namespace boxplus
