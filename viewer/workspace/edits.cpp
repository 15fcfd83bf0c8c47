// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/workspace/edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "boxplus/base/error.h"

namespace boxplus::viewer {
namespace {

std::string name_of(const Graph& graph, EdgeRef edge) {
  constexpr std::size_t kMostIds = 4;
  std::string name = "edge ";
  const std::vector<VertexRef> vertices = graph.vertices(edge);
  for (std::size_t k = 0; k < std::min(vertices.size(), kMostIds); ++k)
    name += fmt::format("{}{}", k > 0 ? " – " : "", graph.id(vertices[k]));
  return vertices.size() > kMostIds ? name + " – …" : name;
}

std::string set_fixed(Graph& graph, VertexRef vertex, bool fixed) {
  const Id id = graph.id(vertex);
  const bool is_free = !graph.is_fixed(vertex) && graph.fixed_directions(vertex).empty();
  if (fixed ? graph.is_fixed(vertex) : is_free)
    throw InvalidArgument(fmt::format("vertex {} is {} already", id, fixed ? "fixed" : "free"));
  graph.set_fixed(vertex, fixed);
  if (!fixed) graph.fix_directions(vertex, {});
  return fmt::format("vertex {} is {}", id, fixed ? "fixed" : "free");
}

std::string remove(Graph& graph, VertexRef vertex) {
  if (graph.vertex_count() == 1) throw InvalidArgument("the last vertex cannot be removed");
  const std::size_t edges = graph.edges(vertex).size();
  const Id id = graph.id(vertex);
  graph.remove(vertex);
  if (edges == 0) return fmt::format("vertex {} is removed", id);
  return fmt::format("vertex {} is removed, with its {} edge{}", id, edges, edges == 1 ? "" : "s");
}

std::string remove(Graph& graph, EdgeRef edge) {
  const std::string name = name_of(graph, edge);
  graph.remove(edge);
  return name + " is removed";
}

std::string set_enabled(Graph& graph, EdgeRef edge, bool enabled) {
  const char* state = enabled ? "enabled" : "disabled";
  if (graph.is_enabled(edge) == enabled)
    throw InvalidArgument(fmt::format("{} is {} already", name_of(graph, edge), state));
  graph.set_enabled(edge, enabled);
  return fmt::format("{} is {}", name_of(graph, edge), state);
}

std::string scale(Graph& graph, EdgeRef edge, double factor) {
  constexpr double kLeast = 1e-9, kLargest = 1e9;
  if (!(factor >= kLeast && factor <= kLargest))
    throw InvalidArgument(
        fmt::format("factor: expected a number from {:g} to {:g}, got {:g}", kLeast, kLargest, factor));
  const Information::View omega = graph.information(edge);
  std::vector<double> triangle;
  for (int i = 0; i < omega.rows; ++i) {
    for (int j = i; j < omega.rows; ++j) triangle.push_back(factor * omega(i, j));
  }
  graph.set_information(edge, Information::upper_triangle(triangle, omega.rows));
  return fmt::format("Ω of {} is multiplied by {:g}", name_of(graph, edge), factor);
}

std::string apply(const Edit& edit, Graph& graph, VertexRef vertex) {
  switch (edit.kind) {
    case Edit::Kind::kFix:
      return set_fixed(graph, vertex, true);
    case Edit::Kind::kFree:
      return set_fixed(graph, vertex, false);
    case Edit::Kind::kRemove:
      return remove(graph, vertex);
    default:
      throw InvalidArgument("only an edge can be disabled, enabled or scaled");
  }
}

std::string apply(const Edit& edit, Graph& graph, EdgeRef edge) {
  switch (edit.kind) {
    case Edit::Kind::kRemove:
      return remove(graph, edge);
    case Edit::Kind::kDisable:
      return set_enabled(graph, edge, false);
    case Edit::Kind::kEnable:
      return set_enabled(graph, edge, true);
    case Edit::Kind::kScale:
      return scale(graph, edge, edit.factor);
    default:
      throw InvalidArgument("only a vertex can be fixed or freed");
  }
}

}  // namespace

std::string apply(const Edit& edit, Graph& graph, const Structure& structure) {
  const Element element = find_element(graph, structure, edit.element);
  return std::visit([&](const auto& ref) { return apply(edit, graph, ref); }, element);
}

}  // namespace boxplus::viewer
