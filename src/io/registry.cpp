// SPDX-License-Identifier: BSD-3-Clause
#include "boxplus/io/registry.h"

#include <algorithm>
#include <array>

#include "boxplus/base/thread_scratch.h"

namespace boxplus {
namespace {

/// Whether the edge's vertices are parameters where the tag says so, and nowhere else.
bool has_parameters_of(const Tag& tag, const Graph& graph, std::span<const VertexRef> vertices) {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Tag::Argument& argument = tag.arguments[std::min(i, tag.arguments.size() - 1)];
    if (graph.vertex_pools()[vertices[i].pool]->parameter(vertices[i].slot) != argument.is_parameter)
      return false;
  }
  return true;
}

}  // namespace

std::span<const double> read_triangle(FieldReader& in, int rows) {
  const std::size_t count = static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows + 1) / 2;
  if (const auto converted = in.converted(count); !converted.empty()) return converted;
  auto& values = thread_scratch<std::vector<double>, struct Triangle>();
  values.resize(count);
  for (double& value : values) value = in.number("an entry of the information matrix");
  return values;
}

Information checked_information(FieldReader& in, std::int64_t column, std::span<const double> triangle,
                                int rows) {
  Information information = Information::upper_triangle(triangle, rows);
  // Where the columns are not known, the graph's own complaint suffices.
  if (const std::string complaint = column > 0 ? information.complaint(rows) : ""; !complaint.empty())
    in.fail(column, complaint);
  if (std::all_of(triangle.begin(), triangle.end(), [](double value) { return value == 0; }))
    in.fail(column, "information: expected a matrix that weighs something, got zeros only");
  return information;
}

Information read_information(FieldReader& in, int rows) {
  const std::int64_t column = in.column();
  return checked_information(in, column, read_triangle(in, rows), rows);
}

void write_information(const InformationView& information, FieldWriter& out) {
  for (int i = 0; i < information.rows; ++i) {
    for (int j = i; j < information.rows; ++j) out.number(information(i, j));
  }
}

const Tag* Registry::find(std::string_view name) const {
  const auto found = tags_.find(name);
  return found == tags_.end() ? nullptr : found->second.get();
}

void Registry::add(Tag tag) {
  const auto is_odd = [](unsigned char c) { return c <= ' '; };
  if (tag.name.empty() || tag.name[0] == '#' || tag.name == "FIX" ||
      std::any_of(tag.name.begin(), tag.name.end(), is_odd)) {
    throw InvalidArgument("registry: expected a word without blanks, got '" + tag.name + "'");
  }
  auto shared = std::make_shared<const Tag>(std::move(tag));
  if (!tags_.try_emplace(shared->name, shared).second) {
    throw InvalidArgument("registry: the word " + shared->name + " stands for another type already");
  }
  if (shared->written) by_pool_.emplace(shared->pool, shared);
}

void Registry::add_shared(const std::string& name, Tag tag) {
  const auto found = tags_.find(name);
  if (found == tags_.end()) throw InvalidArgument("registry: expected a known word, got '" + name + "'");
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
  const VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  const Tag::Kind kind = pool.parameter(vertex.slot) ? Tag::Kind::kParameter : Tag::Kind::kVertex;
  const auto [first, last] = by_pool_.equal_range(typeid(pool));
  const auto found = std::find_if(first, last, [&](const auto& entry) { return entry.second->kind == kind; });
  return found == last ? nullptr : found->second.get();
}

const Tag* Registry::tag_of(const Graph& graph, EdgeRef edge) const {
  const EdgePool& pool = *graph.edge_pools()[edge.pool];
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
