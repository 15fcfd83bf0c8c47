// SPDX-License-Identifier: BSD-3-Clause
#include "io/tagged_elements.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// Throws InvalidArgument if the element has no tag. If the registry has few tags, it is that of a format
/// with fixed types: the message names its tags, and the tag of the element in .g2o files.
template <class Ref>
const Tag& tag_of(const Registry& registry, const Graph& graph, Ref element, const char* what,
                  std::string_view type) {
  constexpr std::size_t kFew = 10;
  if (const Tag* tag = registry.tag_of(graph, element)) return *tag;
  const std::vector<std::string> names = registry.names();
  std::string tags;
  if (names.size() <= kFew) {
    tags = fmt::format(" among {}", fmt::join(names, ", "));
    if (const Tag* known = default_registry().tag_of(graph, element)) type = known->name;
  }
  throw InvalidArgument(
      fmt::format("cannot write {} of type {}: no tag is registered for them{}", what, type, tags));
}

}  // namespace

const Tag& tag_to_write(const Registry& registry, const Graph& graph, VertexRef vertex) {
  return tag_of(registry, graph, vertex, "vertices", graph.vertex_pools()[vertex.pool]->type_name());
}

const Tag& tag_to_write(const Registry& registry, const Graph& graph, EdgeRef edge) {
  return tag_of(registry, graph, edge, "edges", graph.edge_pools()[edge.pool]->type_name());
}

std::vector<Id> ids_to_write(const Registry& registry, const Graph& graph, const Tag& tag, EdgeRef edge) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : graph.vertices(edge)) ids.push_back(graph.id(vertex));
  const Tag* named = registry.find(tag.name);
  if (named != &tag && named->shared_parameter.get() == &tag) ids.push_back(ids.back());
  return ids;
}

}  // namespace boxplus
