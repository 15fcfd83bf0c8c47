// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"

#include <algorithm>

#include "boxplus/base/error.h"

namespace boxplus {
namespace {

/// Whether exactly those vertices of an edge are parameters that the tag declares as parameters.
bool has_parameters_of(const Tag& tag, const Graph& graph, std::span<const VertexRef> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Tag::Argument& argument = tag.arguments[std::min(i, tag.arguments.size() - 1)];
    if (graph.vertex_pools()[vertices[i].pool]->parameter(vertices[i].slot) != argument.is_parameter)
      return false;
  }
  return true;
}

}  // namespace

const Tag* Registry::find(std::string_view name) const {
  const auto found = tags_.find(name);
  return found == tags_.end() ? nullptr : found->second.get();
}

void Registry::add(Tag tag) {
  const auto is_odd = [](unsigned char c) { return c <= ' '; };
  if (tag.name.empty() || tag.name[0] == '#' || tag.name == "FIX" ||
      std::any_of(tag.name.begin(), tag.name.end(), is_odd)) {
    throw InvalidArgument(
        "registry: expected a tag without blanks, other than FIX and not beginning with #, got '" + tag.name +
        "'");
  }
  auto shared = std::make_shared<const Tag>(std::move(tag));
  if (!tags_.try_emplace(shared->name, shared).second) {
    throw InvalidArgument("registry: the tag " + shared->name + " is already registered for another type");
  }
  if (shared->written) by_pool_.emplace(shared->pool, shared);
}

void Registry::add_old(Tag tag) {
  tag.written = false;
  add(std::move(tag));
}

void Registry::add_shared(const std::string& name, Tag tag) {
  const auto found = tags_.find(name);
  if (found == tags_.end()) throw InvalidArgument("registry: expected a known tag, got '" + name + "'");
  auto variant = std::make_shared<const Tag>(std::move(tag));
  Tag changed = *found->second;
  changed.shared_parameter = variant;
  const auto [first, last] = by_pool_.equal_range(changed.pool);
  auto replacement = std::make_shared<const Tag>(std::move(changed));
  for (auto entry = first; entry != last; ++entry) {
    if (entry->second == found->second) entry->second = replacement;
  }
  found->second = replacement;
  by_pool_.emplace(variant->pool, variant);
}

const Tag* Registry::tag_of(const Graph& graph, VertexRef vertex) const {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  const Tag::Kind kind = pool.parameter(vertex.slot) ? Tag::Kind::kParameter : Tag::Kind::kVertex;
  const auto [first, last] = by_pool_.equal_range(typeid(pool));
  const auto found = std::find_if(first, last, [&](const auto& entry) { return entry.second->kind == kind; });
  return found == last ? nullptr : found->second.get();
}

const Tag* Registry::tag_of(const Graph& graph, EdgeRef edge) const {
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  const auto [first, last] = by_pool_.equal_range(typeid(pool));
  const auto found = std::find_if(
      first, last, [&](const auto& entry) { return has_parameters_of(*entry.second, graph, vertices); });
  return found == last ? nullptr : found->second.get();
}

const Registry& default_registry() {
  static const Registry registry = [] {
    Registry all;
    register_slam2d(all);
    register_slam3d(all);
    register_toro(all);
    return all;
  }();
  return registry;
}

}  // namespace boxplus
