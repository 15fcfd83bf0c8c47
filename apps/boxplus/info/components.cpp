// SPDX-License-Identifier: BSD-3-Clause
#include "info/components.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace boxplus::app {
namespace {

/// Disjoint sets of vertex ids (union-find with path halving).
class Sets {
 public:
  explicit Sets(const Graph& graph) {
    for (const VertexRef& vertex : graph.all_vertices()) index_.emplace(graph.id(vertex), index_.size());
    parent_.resize(index_.size());
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(Id id) {
    std::size_t x = index_.at(id);
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void join(Id a, Id b) {
    const std::size_t x = find(a), y = find(b);
    parent_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::unordered_map<Id, std::size_t> index_;  // the position of each vertex in the list sorted by id
  std::vector<std::size_t> parent_;
};

std::vector<Id> ids_of(const Graph& graph, EdgeRef edge) {
  std::vector<Id> ids;
  for (const VertexRef& vertex : graph.vertices(edge)) {
    if (!graph.vertex_pools()[vertex.pool]->parameter(vertex.slot)) ids.push_back(graph.id(vertex));
  }
  return ids;
}

}  // namespace

void find_components(const Graph& graph, const Plan& plan, const viewer::EdgeRoles& role_of_edge,
                     GraphFacts& facts) {
  const std::vector<EdgeRef> edges = graph.all_edges();
  Sets sets(graph);
  for (const EdgeRef& edge : edges) {
    const std::vector<Id> ids = ids_of(graph, edge);
    for (const Id id : ids) sets.join(ids.front(), id);
  }
  std::unordered_map<std::size_t, ComponentFacts> components;  // the key is the root of the set
  for (const VertexRef& vertex : graph.all_vertices()) {
    const Id id = graph.id(vertex);
    ComponentFacts& component = components[sets.find(id)];
    if (component.vertices++ == 0) component.first = id;
    if (graph.is_fixed(vertex)) component.fixed.push_back(id);
  }
  for (const EdgeRef& edge : edges) {
    const std::vector<Id> ids = ids_of(graph, edge);
    if (ids.empty()) continue;
    ComponentFacts& component = components[sets.find(ids.front())];
    ++component.edges;
    component.priors += role_of_edge(edge) == viewer::EdgeRole::kPrior;
  }
  for (const detail::GaugeVertex& held : plan.held) components[sets.find(held.id)].held.push_back(held.id);
  for (const detail::GaugeFreedom& freedom : plan.freedoms)
    components[sets.find(freedom.id)].free = to_string(freedom);

  for (auto& [root, component] : components) {
    if (component.edges == 0) {
      facts.isolated.push_back(component.first);
    } else {
      facts.components.push_back(std::move(component));
    }
  }
  std::sort(facts.isolated.begin(), facts.isolated.end());
  std::sort(facts.components.begin(), facts.components.end(), [](const auto& a, const auto& b) {
    return a.vertices != b.vertices ? a.vertices > b.vertices : a.first < b.first;
  });
}

}  // namespace boxplus::app
