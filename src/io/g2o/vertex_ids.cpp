// SPDX-License-Identifier: BSD-3-Clause
#include "io/g2o/vertex_ids.h"

#include <fmt/format.h>

#include <algorithm>

namespace boxplus {
namespace {

const char* kind_of(bool is_parameter) {
  return is_parameter ? "parameter" : "vertex";
}

std::string repetition(bool is_parameter, Id id) {
  return fmt::format("expected different vertices, but {} {} appears twice", kind_of(is_parameter), id);
}

/// Says which tags define a parameter of the type of the argument. Empty if the argument is a vertex.
std::string definition_of(const Registry& registry, const Tag::Argument& argument) {
  std::string tags;
  if (!argument.is_parameter) return tags;
  for (const std::string& name : registry.names()) {
    const Tag& tag = *registry.find(name);
    if (tag.kind == Tag::Kind::kParameter && tag.written && tag.pool == argument.pool)
      tags += (tags.empty() ? "" : " or ") + name;
  }
  return tags.empty() ? tags : fmt::format("; parameters of its type have the tag {}", tags);
}

}  // namespace

VertexIds::Result VertexIds::read_of_edge(const Tag& tag, FieldReader& in) {
  vertices_.clear();
  missing_.clear();
  Result result = Result::kKnown;
  for (const Tag::Argument& argument : tag.arguments) {
    if (!argument.is_tail) {
      result = std::max(result, read_one(argument, in));
    } else {
      while (!in.accept("||")) result = std::max(result, read_one(argument, in));
    }
  }
  if (result != Result::kNotYetKnown && !missing_.empty()) create_missing(tag, in);
  return result;
}

VertexIds::Result VertexIds::read_one(const Tag::Argument& argument, FieldReader& in) {
  const bool is_parameter = argument.is_parameter;
  const FieldPlace place = in.place();
  const Id id = in.integer(is_parameter ? "the id of a parameter" : "the id of a vertex");
  if (id == -1 && !is_parameter) return Result::kUnassigned;
  if (id < 0)
    in.fail(place, fmt::format("expected the id of a {} (a number ≥ 0), got {}", kind_of(is_parameter), id));
  const auto found = is_parameter ? graph_.find_parameter(id) : graph_.find_vertex(id);
  if (!found && !all_known_) return Result::kNotYetKnown;
  if (!found && !is_parameter && create_) {
    missing_.push_back({vertices_.size(), id, argument.create});
    vertices_.push_back({});
    return Result::kKnown;
  }
  if (!found) fail_unknown(place, id, is_parameter, in, definition_of(registry_, argument));
  const detail::VertexPool& pool = *graph_.vertex_pools()[found->pool];
  if (std::type_index(typeid(pool)) != argument.pool) {
    in.fail(place, fmt::format("expected the id of a {0} of type {1}, but {0} {2} is a {3}",
                               kind_of(is_parameter), argument.type_name, id, pool.type_name()));
  }
  vertices_.push_back(*found);
  return Result::kKnown;
}

void VertexIds::create_missing(const Tag& tag, FieldReader in) {
  for (const Missing& vertex : missing_) {
    const bool again = std::any_of(missing_.begin(), missing_.end(), [&](const Missing& other) {
      return other.id == vertex.id && other.index != vertex.index;
    });
    if (again) in.fail({}, repetition(false, vertex.id));
  }
  tag.check_edge(in);
  for (const Missing& vertex : missing_) vertices_[vertex.index] = vertex.create(graph_, vertex.id);
  created_ += static_cast<std::int64_t>(missing_.size());
}

bool VertexIds::read_to_end(FieldReader& in) {
  vertices_.clear();
  do {
    const FieldPlace place = in.place();
    const Id id = in.integer("the id of a vertex");
    const auto vertex = graph_.find_vertex(id);
    if (!vertex && !all_known_) return false;
    if (!vertex) fail_unknown(place, id, false, in);
    vertices_.push_back(*vertex);
  } while (!in.at_end());
  return true;
}

/// `remedy` says how to define the vertex. It is only shown if the file does not give the reason itself.
void VertexIds::fail_unknown(FieldPlace place, Id id, bool is_parameter, const FieldReader& in,
                             const std::string& remedy) const {
  const std::string reason = unknown_.reason_for_missing(id, is_parameter);
  in.fail(place, fmt::format("expected the id of a {0}, but there is no {0} {1}{2}", kind_of(is_parameter),
                             id, reason.empty() ? remedy : reason));
}

const Tag& VertexIds::merge_shared_parameter(const Tag& tag) {
  if (!tag.shared_parameter || vertices_.back() != vertices_[vertices_.size() - 2]) return tag;
  vertices_.pop_back();
  return *tag.shared_parameter;
}

void VertexIds::refuse_repetition(const FieldReader& in) {
  if (vertices_.size() == 2 && vertices_[0] != vertices_[1]) return;
  sorted_ = vertices_;
  std::sort(sorted_.begin(), sorted_.end());
  const auto twice = std::adjacent_find(sorted_.begin(), sorted_.end());
  if (twice == sorted_.end()) return;
  const bool is_parameter = graph_.vertex_pools()[twice->pool]->parameter(twice->slot);
  in.fail({}, repetition(is_parameter, graph_.id(*twice)));
}

}  // namespace boxplus
