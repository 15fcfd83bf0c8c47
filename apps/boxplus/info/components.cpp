// SPDX-License-Identifier: BSD-3-Clause
#include "info/components.h"

#include <algorithm>
#include <unordered_map>

namespace boxplus::app {

Components find_components(const Graph& graph, const Plan& plan, const EdgeRoles& role_of_edge) {
  const GraphView& view = role_of_edge.view();
  DisjointSets sets = view.components();
  std::unordered_map<std::uint32_t, ComponentFacts> components;  // the key is the root of the set
  const auto component_of = [&](VertexRef vertex) -> ComponentFacts& {
    return components[sets.find(view.number(vertex))];
  };
  for (const VertexRef& vertex : graph.all_vertices()) {
    const Id id = graph.id(vertex);
    ComponentFacts& component = component_of(vertex);
    if (component.vertices++ == 0) component.first = id;
    if (graph.is_fixed(vertex)) component.fixed.push_back(id);
  }
  for (const EdgeRef& edge : graph.all_edges()) {
    const std::uint32_t end = view.first_end(edge);
    if (end == GraphView::kNone) continue;
    ComponentFacts& component = components[sets.find(end)];
    ++component.edges;
    component.priors += role_of_edge(edge) == EdgeRole::kPrior;
  }
  for (const detail::GaugeVertex& held : plan.held)
    component_of(*graph.find_vertex(held.id)).held.push_back(held.id);
  for (const detail::GaugeFreedom& freedom : plan.freedoms)
    component_of(*graph.find_vertex(freedom.id)).free = to_string(freedom);

  Components result;
  for (auto& [root, component] : components) {
    if (component.edges == 0) {
      result.isolated.push_back(component.first);
    } else {
      result.with_edges.push_back(std::move(component));
    }
  }
  std::sort(result.isolated.begin(), result.isolated.end());
  std::sort(result.with_edges.begin(), result.with_edges.end(), [](const auto& a, const auto& b) {
    return a.vertices != b.vertices ? a.vertices > b.vertices : a.first < b.first;
  });
  return result;
}

}  // namespace boxplus::app
