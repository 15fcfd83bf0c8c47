// SPDX-License-Identifier: BSD-3-Clause
#include "io/tagged_elements.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// Throws InvalidArgument if `tag` is null. Names the tags of the registry if they are few.
const Tag& require(const Tag* tag, const Registry& registry, const char* what, std::string_view type) {
  constexpr std::size_t kFew = 10;
  if (tag != nullptr) return *tag;
  const std::vector<std::string> names = registry.names();
  const std::string tags = names.size() > kFew ? "" : fmt::format(" among {}", fmt::join(names, ", "));
  throw InvalidArgument(
      fmt::format("cannot write {} of type {}: no tag is registered for them{}", what, type, tags));
}

}  // namespace

const Tag& tag_to_write(const Registry& registry, const Graph& graph, VertexRef vertex) {
  return require(registry.tag_of(graph, vertex), registry, "vertices",
                 graph.vertex_pools()[vertex.pool]->type_name());
}

const Tag& tag_to_write(const Registry& registry, const Graph& graph, EdgeRef edge) {
  return require(registry.tag_of(graph, edge), registry, "edges", graph.edge_pools()[edge.pool]->type_name());
}

std::vector<Id> ids_to_write(const Registry& registry, const Graph& graph, const Tag& tag, EdgeRef edge) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : graph.vertices(edge)) ids.push_back(graph.id(vertex));
  const Tag* named = registry.find(tag.name);
  if (named != &tag && named->shared_parameter.get() == &tag) ids.push_back(ids.back());
  return ids;
}

}  // namespace boxplus
