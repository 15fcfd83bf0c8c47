// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/element_reader.h"

#include <fmt/format.h>

#include "boxplus/base/error.h"

namespace boxplus {

Id ElementReader::read_vertex(const Tag& tag, FieldReader& in) {
  const bool is_parameter = tag.kind == Tag::Kind::kParameter;
  const FieldPlace place = in.place();
  const Id id = in.integer(is_parameter ? "the id of a parameter" : "the id of a vertex");
  if (id < 0) in.fail(place, fmt::format("expected an id ≥ 0, got {}", id));
  if (is_parameter ? graph_.find_parameter(id).has_value() : graph_.find_vertex(id).has_value()) {
    in.fail(place, fmt::format("expected a new id, but {} {} is already defined",
                               is_parameter ? "parameter" : "vertex", id));
  }
  tag.read_vertex(graph_, id, in);
  return id;
}

ElementReader::Edge ElementReader::read_edge(const Tag& tag, FieldReader& in) {
  const VertexIds::Result known = ids_.read_of_edge(tag, in);
  if (known == VertexIds::Result::kUnassigned) tag.check_edge(in);
  if (known != VertexIds::Result::kKnown) return {known};
  const Tag& type = ids_.merge_shared_parameter(tag);
  ids_.refuse_repetition(in);
  const FieldPlace place = in.place();
  try {
    return {known, type.read_edge(graph_, ids_.vertices(), in)};
  } catch (const InvalidArgument& error) {  // its message does not contain the line and column
    in.fail(place, error.what());
  }
}

bool ElementReader::fix(FieldReader& in) {
  if (!ids_.read_to_end(in)) return false;
  for (const VertexRef& vertex : ids_.vertices()) graph_.fix(vertex);
  return true;
}

}  // namespace boxplus
