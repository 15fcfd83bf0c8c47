// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/scene/element.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "boxplus/base/error.h"
#include "boxplus/io/registry.h"
#include "viewer/scene/estimate_text.h"

namespace boxplus::viewer {
namespace {

/// The text of a long measurement is cut.
constexpr std::size_t kLongestText = 2000;

VertexRef vertex_with_number(const Graph& graph, const Structure& structure, std::uint64_t number) {
  for (const VertexGroup& group : structure.vertices) {
    if (number < group.first || number - group.first >= group.slots.size()) continue;
    const std::uint32_t slot = group.slots[number - group.first];
    return {group.pool, slot, graph.vertex_pools()[group.pool]->generation(slot)};
  }
  throw InvalidArgument(fmt::format("vertex: expected a number below {}, got {}", structure.count, number));
}

VertexRef vertex_with_id(const Graph& graph, std::uint64_t id) {
  constexpr auto kLargest = static_cast<std::uint64_t>(std::numeric_limits<Id>::max());
  const auto found = id <= kLargest ? graph.find_vertex(static_cast<Id>(id)) : std::nullopt;
  if (!found) throw InvalidArgument(fmt::format("there is no vertex {}", id));
  return *found;
}

EdgeRef edge_of_line(const Graph& graph, const Structure& structure, std::uint64_t line) {
  for (const LineGroup& group : structure.line_groups) {
    if (line < group.first || line - group.first >= group.count) continue;
    const std::uint32_t slot = structure.line_edges[line];
    return {group.pool, slot, graph.edge_pools()[group.pool]->generation(slot)};
  }
  throw InvalidArgument(
      fmt::format("line: expected a number below {}, got {}", structure.line_edges.size(), line));
}

EdgeRef edge_with_number(const Graph& graph, std::uint64_t number) {
  std::uint64_t rest = number;
  for (std::uint32_t index = 0; index < graph.edge_pools().size(); ++index) {
    const detail::EdgePool& pool = *graph.edge_pools()[index];
    if (rest < pool.slots()) {
      const auto slot = static_cast<std::uint32_t>(rest);
      if (pool.alive(slot)) return {index, slot, pool.generation(slot)};
      break;
    }
    rest -= pool.slots();
  }
  throw InvalidArgument(fmt::format("there is no edge with the number {}", number));
}

/// The position of a slot in an ascending list of slots.
std::optional<std::uint32_t> position_in(std::span<const std::uint32_t> slots, std::uint32_t slot) {
  const auto found = std::lower_bound(slots.begin(), slots.end(), slot);
  if (found == slots.end() || *found != slot) return std::nullopt;
  return static_cast<std::uint32_t>(found - slots.begin());
}

std::optional<std::uint32_t> line_of(const Structure& structure, EdgeRef edge) {
  const Lines lines = lines_of(structure, edge);
  return lines.count > 0 ? std::optional(lines.first) : std::nullopt;
}

/// What `write` writes, without blanks at the ends.
template <class F>
std::string written(F&& write) {
  std::string text;
  FieldWriter out(text);
  write(out);
  const std::size_t begin = text.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  text.erase(0, begin);
  if (text.size() <= kLongestText) return text;
  return text.substr(0, text.rfind(' ', kLongestText)) + " …";
}

EdgeFacts::End end_of(const Graph& graph, const Structure& structure, VertexRef vertex) {
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  return {pool.id(vertex.slot), std::string(pool.type_name()), pool.parameter(vertex.slot),
          number_of(structure, vertex)};
}

/// The edges of a vertex with the largest chi2 per row, in descending order.
std::vector<EdgeRef> worst_edges(const Graph& graph, std::vector<EdgeRef> edges) {
  std::vector<std::pair<double, EdgeRef>> ranked;
  for (const EdgeRef& edge : edges) {
    const double chi2 = graph.chi2(edge) / std::max(1, graph.edge_pools()[edge.pool]->shape(edge.slot).rows);
    ranked.emplace_back(std::isnan(chi2) ? std::numeric_limits<double>::infinity() : chi2, edge);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  ranked.resize(std::min(ranked.size(), kMostListed));
  edges.clear();
  for (const auto& each : ranked) edges.push_back(each.second);
  return edges;
}

}  // namespace

std::optional<std::uint32_t> number_of(const Structure& structure, VertexRef vertex) {
  for (const VertexGroup& group : structure.vertices) {
    if (group.pool != vertex.pool) continue;
    if (const auto position = position_in(group.slots, vertex.slot)) return group.first + *position;
  }
  return std::nullopt;
}

Lines lines_of(const Structure& structure, EdgeRef edge) {
  for (const LineGroup& group : structure.line_groups) {
    if (group.pool != edge.pool) continue;
    const auto slots = std::span(structure.line_edges).subspan(group.first, group.count);
    const auto [begin, end] = std::equal_range(slots.begin(), slots.end(), edge.slot);
    if (begin != end)
      return {group.first + static_cast<std::uint32_t>(begin - slots.begin()),
              static_cast<std::uint32_t>(end - begin)};
  }
  return {};
}

std::uint64_t number_of(const Graph& graph, EdgeRef edge) {
  std::uint64_t number = edge.slot;
  for (std::uint32_t index = 0; index < edge.pool; ++index) number += graph.edge_pools()[index]->slots();
  return number;
}

Element find_element(const Graph& graph, const Structure& structure, const ElementName& name) {
  switch (name.kind) {
    case ElementName::Kind::kVertex:
      return vertex_with_number(graph, structure, name.number);
    case ElementName::Kind::kId:
      return vertex_with_id(graph, name.number);
    case ElementName::Kind::kLine:
      return edge_of_line(graph, structure, name.number);
    default:
      return edge_with_number(graph, name.number);
  }
}

EdgeFacts facts_of(const Graph& graph, const Structure& structure, EdgeRef edge) {
  EdgeFacts facts;
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  facts.edge = edge;
  facts.number = number_of(graph, edge);
  facts.line = line_of(structure, edge);
  facts.type = pool.type_name();
  if (const Tag* tag = default_registry().tag_of(graph, edge)) {
    facts.tag = tag->name;
    facts.fields = written([&](FieldWriter& out) { tag->write_edge(graph, edge, out); });
  }
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  facts.vertices = vertices.size();
  for (std::size_t k = 0; k < std::min(vertices.size(), kMostListed); ++k)
    facts.ends.push_back(end_of(graph, structure, vertices[k]));
  facts.rows = pool.shape(edge.slot).rows;
  facts.level = pool.level(edge.slot);
  facts.error = graph.error(edge);
  if (facts.error.size() > kMostListed) facts.error.resize(kMostListed);
  facts.chi2 = graph.chi2(edge);
  facts.weight = graph.weight(edge);
  if (const RobustKernel* kernel = graph.kernel(edge)) facts.kernel = kernel->name();
  facts.is_enabled = graph.is_enabled(edge);
  return facts;
}

VertexFacts facts_of(const Graph& graph, const Structure& structure, VertexRef vertex) {
  VertexFacts facts;
  const detail::VertexPool& pool = *graph.vertex_pools()[vertex.pool];
  facts.id = graph.id(vertex);
  facts.number = number_of(structure, vertex);
  facts.type = pool.type_name();
  if (const Tag* tag = default_registry().tag_of(graph, vertex)) {
    facts.tag = tag->name;
    facts.estimate = written([&](FieldWriter& out) { tag->write_vertex(graph, vertex, out); });
  } else {
    facts.estimate = estimate_text(graph, vertex);
  }
  facts.is_fixed = graph.is_fixed(vertex);
  const auto directions = graph.fixed_directions(vertex);
  facts.fixed_directions.assign(directions.begin(), directions.end());
  const std::vector<EdgeRef> edges = graph.edges(vertex);
  facts.edge_count = edges.size();
  for (const EdgeRef& edge : worst_edges(graph, edges))
    facts.edges.push_back(facts_of(graph, structure, edge));
  return facts;
}

}  // namespace boxplus::viewer
