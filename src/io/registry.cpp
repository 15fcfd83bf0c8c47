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

const Tag& Registry::get(const std::string& name) const {
  const Tag* tag = find(name);
  if (tag == nullptr) throw InvalidArgument("registry: expected a known tag, got '" + name + "'");
  return *tag;
}

void Registry::add(Tag tag, std::string example) {
  tag.example = std::move(example);
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

void Registry::add_old(Tag tag, std::string example) {
  tag.written = false;
  add(std::move(tag), std::move(example));
}

void Registry::add_shared(Tag tag, std::string example) {
  tag.example = std::move(example);
  Tag changed = get(tag.name);
  const auto found = tags_.find(tag.name);
  auto variant = std::make_shared<const Tag>(std::move(tag));
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

std::vector<std::string> Registry::names() const {
  std::vector<std::string> names;
  for (const auto& [name, tag] : tags_) names.push_back(name);
  return names;
}

/// The line of a vertex or parameter with this id. An old tag is used only if there is no other tag.
std::string Registry::example_of(const Tag::Argument& argument, Id id) const {
  const Tag* best = nullptr;
  for (const auto& [name, tag] : tags_) {
    const bool fits = !tag->example.empty() && tag->pool == argument.pool &&
                      (tag->kind == Tag::Kind::kParameter) == argument.is_parameter;
    if (fits && (best == nullptr || tag->written > best->written)) best = tag.get();
  }
  if (best == nullptr) {
    throw InvalidArgument("registry: expected an example for vertices of type " +
                          std::string(argument.type_name));
  }
  const std::string& fields = best->example;
  return best->name + ' ' + std::to_string(id) + fields.substr(std::min(fields.find(' '), fields.size())) +
         '\n';
}

std::string Registry::example(const std::string& name) const {
  const Tag& tag = get(name);
  if (tag.example.empty()) throw InvalidArgument("registry: expected an example for the tag '" + name + "'");
  std::map<std::pair<bool, Id>, std::string> vertices;  // parameters first, then sorted by id
  std::string lines;
  for (const Tag* variant = &tag; variant != nullptr; variant = variant->shared_parameter.get()) {
    if (variant->example.empty()) continue;
    lines += name + ' ' + variant->example + '\n';
    FieldReader in(name, 1, variant->example);
    const auto add_vertex = [&](const Tag::Argument& argument) {
      const Id id = in.integer("an id");
      vertices[{!argument.is_parameter, id}] = example_of(argument, id);
    };
    for (const Tag::Argument& argument : tag.arguments) {
      if (!argument.is_tail) {
        add_vertex(argument);
      } else {
        while (!in.accept("||")) add_vertex(argument);
      }
    }
  }
  std::string text;
  for (const auto& [id, line] : vertices) text += line;
  return text + lines;
}

const Registry& default_registry() {
  static const Registry registry = [] {
    Registry all;
    register_slam2d(all);
    register_slam3d(all);
    register_ba(all);
    register_toro(all);
    return all;
  }();
  return registry;
}

}  // namespace boxplus
