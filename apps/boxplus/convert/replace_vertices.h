// SPDX-License-Identifier: BSD-3-Clause
// Replaces vertices and edges of a graph by others of other types.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <typeinfo>
#include <vector>

#include "boxplus/base/error.h"
#include "boxplus/io/graph_file.h"

namespace boxplus::app {

/// Replaces all vertices of the type Old by vertices of the type New with the same ids, and their edges by
/// edges at the same places in the file, with the same kernels, levels and enabled flags.
/// Call add_vertices() first, then replace_edges(), once each. If one of them
/// throws, the graph is not usable.
template <class Old, class New>
class VertexReplacement {
 public:
  explicit VertexReplacement(GraphFile& file) : file_(file) {
    Graph& graph = file_.graph;
    for (const VertexRef& vertex : graph.all_vertices()) {
      if (is_old(vertex)) old_.push_back(vertex);
    }
  }

  bool is_needed() const { return !old_.empty(); }

  /// `convert(const Old&)` returns a New. Fixed directions are kept if both types have the same dimension.
  template <class Convert>
  void add_vertices(Convert&& convert) {
    Graph& graph = file_.graph;
    Id free_id = graph.id(graph.all_vertices().back()) + 1;
    for (const VertexRef& old : old_) {
      const Id id = graph.id(old);
      const auto typed = graph.typed<Old>(old);
      graph.change_id(old, free_id++);
      const auto added = graph.add_vertex(convert(graph.estimate(typed)), id);
      graph.set_fixed(added, graph.is_fixed(old));
      graph.set_eliminated(added, graph.is_eliminated(old));
      const std::span<const int> fixed = graph.fixed_directions(old);
      if constexpr (Manifold<Old>::kDim == Manifold<New>::kDim)
        graph.fix_directions(added, std::vector<int>(fixed.begin(), fixed.end()));
      ids_.emplace(old, id);
    }
  }

  VertexHandle<New> new_vertex(VertexRef old) const { return file_.graph.template vertex<New>(ids_.at(old)); }

  /// Calls `replace(EdgeRef old)` for each edge of old vertices. `replace` must add the new edge and return
  /// it, or return std::nullopt if no edge can replace the old one. In this case, throws InvalidArgument with
  /// a message that begins with `what`.
  template <class Replace>
  void replace_edges(const std::string& what, Replace&& replace) {
    Graph& graph = file_.graph;
    for (EdgeRef& edge : file_.edges) {
      if (!graph.contains(edge) || !has_old_vertex(edge)) continue;
      const std::optional<EdgeRef> added = replace(edge);
      if (!added) throw InvalidArgument(what + ", " + description(edge));
      if (const RobustKernel* kernel = graph.kernel(edge)) graph.set_kernel(*added, kernel->clone());
      graph.set_level(*added, graph.level(edge));
      graph.set_enabled(*added, graph.is_enabled(edge));
      edge = *added;
    }
    for (const VertexRef& old : old_) graph.remove(old);  // and its edges
  }

 private:
  bool is_old(VertexRef vertex) const {
    const detail::VertexPool& pool = *file_.graph.vertex_pools()[vertex.pool];
    return typeid(pool) == typeid(detail::TypedVertexPool<Old>);
  }
  bool has_old_vertex(EdgeRef edge) const {
    const std::vector<VertexRef> vertices = file_.graph.vertices(edge);
    return std::any_of(vertices.begin(), vertices.end(), [&](VertexRef vertex) { return is_old(vertex); });
  }
  /// "got an edge of type Range of the vertices 3, 4"
  std::string description(EdgeRef edge) const {
    const Graph& graph = file_.graph;
    std::string text = "got an edge of type ";
    text += graph.edge_pools()[edge.pool]->type_name();
    const char* separator = " of the vertices ";
    for (const VertexRef& vertex : graph.vertices(edge)) {
      const auto id = ids_.find(vertex);
      text += separator + std::to_string(id == ids_.end() ? graph.id(vertex) : id->second);
      separator = ", ";
    }
    return text;
  }

  GraphFile& file_;
  std::vector<VertexRef> old_;
  std::map<VertexRef, Id> ids_;  // of the old vertices in the file
};

/// Whether an edge has the error function E and vertices of the types V…
template <class E, class... V>
bool is_edge(const Graph& graph, EdgeRef edge) {
  const detail::EdgePool& pool = *graph.edge_pools()[edge.pool];
  return typeid(pool) == typeid(detail::TypedEdgePool<E, V...>);
}

}  // namespace boxplus::app
